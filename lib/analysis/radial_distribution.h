// SPDX-License-Identifier: BSD-3-Clause
// How likely it is to find spheres at a distance, by their sizes.
#pragma once

#include "analysis/bins.h"
#include "analysis/table.h"
#include "packing/packing.h"

namespace jam {

struct RadialDistributionSettings {
    int size_classes = 3;  ///< equal factors of diameter between smallest and largest; at most 8
    int bins = 125;
    double largest = 2.5;  ///< of the scaled distance; less in a cell too small for it
};

/// g_ab(x) of size classes a <= b at the scaled distance x = 2 r / (D_i + D_j), at which equal
/// pairs touch at 1: pairs found over those expected of points without order, g = n_ab(x) V / [4 pi
/// / 3 (x_high^3 - x_low^3) sum over pairs of ((D_i + D_j) / 2)^3].
struct RadialDistribution {
    struct Pair {
        int class_1;
        int class_2;  ///< >= class_1
        std::vector<Count> counts;
        std::vector<double> values;  ///< g; not a number if there is no such pair
    };
    std::vector<double> class_bounds;  ///< diameters; one more than there are classes
    std::vector<Count> class_sizes;
    Bins bins;
    std::vector<Pair> pairs;
};

/// One class where all diameters are one. Throws InputError for settings out of range, and if the
/// cell is narrower than the largest sphere.
RadialDistribution radial_distribution(const Packing& packing,
                                       const RadialDistributionSettings& settings = {});

/// Columns distance_low, distance_high, then g_1_1, g_1_2, ... by class, smallest first.
Table table(const RadialDistribution& distribution);

}  // namespace jam
