// SPDX-License-Identifier: BSD-3-Clause
// A random start without overlap: spheres placed one after the other, largest first.
#pragma once

#include "cell/periodic_cell.h"
#include "particles/particles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace jam {

struct PlacementSettings {
    double volume_fraction = 0.3;
    std::uint64_t seed = 1;
    /// Tries for one sphere before giving up.
    std::uint32_t most_tries = 100000;
};

struct RandomStart {
    PeriodicCell cell;
    std::vector<Vec3> centers;  ///< fractional, by the order of the diameters
};

/// A cubic cell of the given volume fraction with the spheres at uniformly random places that
/// overlap no sphere placed before (random sequential addition, largest first). Spheres touch
/// nobody by at least one part in 10^12. Throws InputError if the cell would be narrower than two
/// largest diameters' reach allows, or if a sphere finds no place.
RandomStart place_at_random(std::span<const double> diameters, const PlacementSettings& settings);

}  // namespace jam
