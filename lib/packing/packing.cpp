// SPDX-License-Identifier: BSD-3-Clause
#include "packing/packing.h"

#include "core/check.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jam {

namespace {

void check_lengths(const Packing& packing) {
    const std::size_t size = packing.positions.size();
    require(size > 0, "packing: has no spheres; it needs at least one");
    require(packing.diameters.size() == size && packing.ids.size() == size,
            "packing: {} positions, {} diameters, {} ids; give one of each a sphere", size,
            packing.diameters.size(), packing.ids.size());
    require(packing.velocities.empty() || packing.velocities.size() == size,
            "packing: {} positions, {} velocities; give one a sphere or none at all", size,
            packing.velocities.size());
}

void check_sphere(const Packing& packing, std::size_t i) {
    const double diameter = packing.diameters[i];
    require(diameter > 0.0 && std::isfinite(diameter),
            "packing: sphere {} has the diameter {}; it must be above zero and finite",
            packing.ids[i], diameter);
    require(packing.positions[i].allFinite(),
            "packing: sphere {} has a position that is not a finite number; correct it",
            packing.ids[i]);
    require(packing.velocities.empty() || packing.velocities[i].allFinite(),
            "packing: sphere {} has a velocity that is not a finite number; correct it",
            packing.ids[i]);
}

void check_distinct(std::vector<std::int64_t> ids) {
    sort_total_order(ids, std::less<>());
    const auto twice = std::adjacent_find(ids.begin(), ids.end());
    require(twice == ids.end(), "packing: two spheres have the id {}; ids must be distinct",
            twice == ids.end() ? 0 : *twice);
}

}  // namespace

void check_packing(const Packing& packing) {
    check_lengths(packing);
    for (std::size_t i = 0; i < packing.positions.size(); ++i) check_sphere(packing, i);
    check_distinct(packing.ids);
}

}  // namespace jam
