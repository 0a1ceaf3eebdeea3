// SPDX-License-Identifier: BSD-3-Clause
// The particles of a run: structure of arrays, each entry one half cache line.
#pragma once

#include "core/types.h"

#include <cstdint>
#include <numbers>
#include <vector>

namespace jam {

/// Where a sphere is. `center` is in fractional coordinates of the cell, so that a strain of the
/// cell moves every particle without touching it; wrapped into [0, 1) when the list is renewed.
struct alignas(32) Sphere {
    Vec3 center;
    double diameter;
};

/// How a sphere moves: velocity relative to the cell's own flow, Cartesian, and inertial mass.
struct alignas(32) Motion {
    Vec3 velocity;
    double mass;
};

/// What acts on a sphere: total contact force, Cartesian, and the number of its contacts.
struct alignas(32) Load {
    Vec3 force;
    double contacts;
};

struct Particles {
    std::vector<Sphere> spheres;
    std::vector<Motion> motions;
    std::vector<Load> loads;         ///< of the last force evaluation; sorting leaves them behind
    std::vector<std::uint32_t> ids;  ///< 0..N-1, in the order in which the diameters were drawn

    Index size() const { return static_cast<Index>(spheres.size()); }
};

inline double sphere_volume(double diameter) {
    return std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

}  // namespace jam
