// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/near_spheres.h"

#include "core/check.h"
#include "core/particle_limit.h"
#include "grids/grid_hierarchy.h"
#include "neighbors/find_neighbors.h"

#include <numeric>
#include <utility>

namespace jam {

WrappedSpheres wrap_spheres(const Packing& packing) {
    require(packing.size() <= max_particle_count,
            "packing: {} particles; at most {} can be analysed", packing.size(),
            max_particle_count);
    const PeriodicCell cell = packing.cell.reduced().cell;
    WrappedSpheres result{cell, std::vector<Sphere>(packing.positions.size())};
    for_each_block(packing.size(), 4096, [&](Count, Count begin, Count end) {
        for (Count i = begin; i < end; ++i)
            result.spheres[i] = {wrapped(cell.fractional(packing.positions[i])),
                                 packing.diameters[i]};
    });
    return result;
}

namespace {

/// The spheres as particles whose ids are their places in the packing.
Particles as_particles(const WrappedSpheres& wrapped) {
    Particles particles;
    particles.spheres = wrapped.spheres;
    particles.motions.resize(wrapped.spheres.size());
    particles.loads.resize(wrapped.spheres.size());
    particles.ids.resize(wrapped.spheres.size());
    std::iota(particles.ids.begin(), particles.ids.end(), 0u);
    return particles;
}

std::vector<double> diameters_of(const std::vector<Sphere>& spheres) {
    std::vector<double> diameters;
    diameters.reserve(spheres.size());
    for (const Sphere& sphere : spheres) diameters.push_back(sphere.diameter);
    return diameters;
}

}  // namespace

NearSphereList::NearSphereList(const WrappedSpheres& wrapped, const InteractionReach& reach)
    : cell_(wrapped.cell) {
    if (wrapped.spheres.empty()) return;
    Particles particles = as_particles(wrapped);
    GridHierarchy hierarchy(geometric_collections(diameters_of(wrapped.spheres)));
    hierarchy.group(particles);
    NeighborScratch scratch;
    find_candidates(hierarchy, cell_, reach, particles, scratch, list_);
    spheres_ = std::move(particles.spheres);
    places_.assign(particles.ids.begin(), particles.ids.end());
}

NearSpheres NearSphereList::pair(Index row, Neighbor neighbor) const {
    Index first = row;
    Index second = neighbor.particle();
    Image image = image_of(neighbor.image());
    if (places_[first] > places_[second]) {
        std::swap(first, second);
        image = -image;
    }
    const Vec3 apart = spheres_[first].center - spheres_[second].center - image.cast<double>();
    return {places_[first], places_[second], image, cell_.cartesian(apart)};
}

}  // namespace jam
