// SPDX-License-Identifier: BSD-3-Clause
// How the diameters of a packing are distributed, and what follows from that without drawing any.
//
// The smallest diameter is 1 unless a table says otherwise. docs/sizes.md has the equations.
#pragma once

#include "core/types.h"

#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

namespace jam {

/// What a cumulative fraction counts: particles, or their volume.
enum class Weight { number, volume };

/// n(D) ~ D^(alpha - 4) for 1 <= D <= size_ratio; beta = 4 - alpha (Monti et al., Eq. 3).
struct PowerLaw {
    double size_ratio = 5.0;
    double alpha = 0.55;
};

/// Small spheres of diameter 1 and large ones of diameter size_ratio.
struct Binary {
    double size_ratio = 5.0;
    double small_fraction = 0.25;  ///< f_S: volume of the small spheres / volume of all
    Count large_count = 100;       ///< with f_S, decides the number of small spheres
};

/// Spheres of diameter 1.
struct Monodisperse {};

/// Volume fraction below D = [(D - 1) / (size_ratio - 1)]^eta (Oquendo-Patino and Estrada, 2020).
struct GrainSizeDistribution {
    double size_ratio = 5.0;
    double eta = 0.6;
};

/// ln D is normal with standard deviation sigma about ln sqrt(size_ratio), cut to
/// 1 <= D <= size_ratio; the default cuts at three sigma to either side of the median.
struct Lognormal {
    double sigma = 0.3;
    double size_ratio = std::exp(6.0 * sigma);
};

/// Given diameters, each as probable as the next. Made by `diameter_list` (size_table.h).
struct DiameterList {
    std::vector<double> diameters;         ///< ascending
    std::vector<double> volume_fractions;  ///< of all up to and with this one; the last is 1
};

/// A cumulative curve, linear in D between its points in the fraction that `given` names. Made by
/// `cumulative_curve` (size_table.h). All arrays have one entry a point.
struct CumulativeCurve {
    Weight given = Weight::volume;
    std::vector<double> diameters;         ///< strictly ascending
    std::vector<double> number_fractions;  ///< from 0 to 1
    std::vector<double> volume_fractions;  ///< from 0 to 1
};

using SizeDistribution = std::variant<PowerLaw, Binary, Monodisperse, GrainSizeDistribution,
                                      Lognormal, DiameterList, CumulativeCurve>;

/// The largest size_ratio accepted: the volumes of its smallest and largest sphere can still be
/// added in double precision (1e15 < 2^53).
inline constexpr double max_size_ratio = 1e5;

/// The alpha accepted: from beta = 5, nearly all particles small, to beta = 0, all sizes equally
/// frequent.
inline constexpr double min_alpha = -1.0;
inline constexpr double max_alpha = 4.0;

/// The eta accepted: the number of particles follows from it only below 3 (docs/sizes.md).
inline constexpr double min_eta = 0.05;
inline constexpr double max_eta = 2.5;

/// The sigma of a lognormal accepted: below, spheres are equal; above, three sigma to either side
/// reach beyond any packing.
inline constexpr double min_sigma = 0.01;
inline constexpr double max_sigma = 1.5;

/// Name of the kind as scenes have it: "power-law", "binary", "monodisperse",
/// "grain-size-distribution", "lognormal" or "table".
std::string_view kind_name(const SizeDistribution& sizes);

/// Throws InputError that names the key ("sizes.size_ratio", ...), its value, the rule and the
/// remedy unless every value can be used. All functions below rely on this.
void check(const SizeDistribution& sizes);

double smallest_diameter(const SizeDistribution& sizes);
double largest_diameter(const SizeDistribution& sizes);

/// Fraction of the particles per unit of diameter, at D; infinite at a diameter that a finite
/// fraction of the particles has.
double number_density(const SizeDistribution& sizes, double diameter);

/// Fraction of the particles, or of their volume, in diameters up to and with D.
double cumulative_fraction(const SizeDistribution& sizes, Weight weight, double diameter);

/// The smallest D whose cumulative fraction is at least `fraction`, which lies in [0, 1].
double quantile(const SizeDistribution& sizes, Weight weight, double fraction);

/// Mean of D^order over the particles.
double moment(const SizeDistribution& sizes, double order);

/// Mean volume of a particle, pi/6 <D^3>.
double mean_volume(const SizeDistribution& sizes);

}  // namespace jam
