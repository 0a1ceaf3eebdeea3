// SPDX-License-Identifier: BSD-3-Clause
// Random spheres in random cells, for the tests of everything that deals with pairs.
#pragma once

#include "cell/periodic_cell.h"
#include "particles/particles.h"

#include <cstdint>
#include <vector>

namespace jam::test {

struct RandomPacking {
    PeriodicCell cell;
    Particles particles;
};

struct RandomPackingSettings {
    int count = 200;
    double size_ratio = 5.0;
    double volume_fraction = 0.7;  ///< spheres overlap freely
    double largest_tilt = 0.5;     ///< of the edge that it is measured along
    /// The cell is at least this many largest diameters wide.
    double least_width = 1.1;
};

/// Diameters uniform in their logarithm over [1, size_ratio], both ends present; centers uniform,
/// also outside the first image; random small velocities; masses by volume.
RandomPacking random_packing(std::uint64_t seed, const RandomPackingSettings& settings);

/// The diameters in the order of the particles.
std::vector<double> diameters_of(const Particles& particles);

}  // namespace jam::test
