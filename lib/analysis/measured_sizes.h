// SPDX-License-Identifier: BSD-3-Clause
// The size distribution that a packing has, whatever it was made from.
#pragma once

#include "analysis/power_law_fit.h"
#include "analysis/table.h"

#include <span>
#include <vector>

namespace jam {

/// Fraction of the particles' volume in diameters up to and with D, at D logarithmically spaced
/// (Monti et al., Fig. 1a and Eq. 3).
struct CumulativeVolume {
    std::vector<double> diameters;
    std::vector<double> reduced;    ///< (D - min D) / (max D - min D); zero if they are one
    std::vector<double> fractions;  ///< ends at 1
};

CumulativeVolume cumulative_volume(std::span<const double> diameters, int points_per_decade = 40);

/// Columns diameter, reduced_diameter, volume_fraction_below.
Table table(const CumulativeVolume& volume);

/// The power law P(D) ~ D^-beta that describes the diameters best, by maximum likelihood between
/// the smallest and the largest; of use only where they follow one.
struct SizePowerLaw {
    double beta = 0.0;
    double alpha = 0.0;  ///< 4 - beta: volume below D goes as D^alpha
    double fractal_dimension =
        0.0;             ///< beta - 1: the number above D goes as D^-d_f (Turcotte, 1986)
    double error = 0.0;  ///< standard error of each, for diameters drawn at random
};

/// Not a number if all diameters are one.
SizePowerLaw fit_sizes(std::span<const double> diameters);

}  // namespace jam
