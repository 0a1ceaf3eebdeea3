// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/closest_alpha.h"

#include "core/check.h"
#include "sizes/size_distribution.h"

#include <boost/math/tools/minima.hpp>

namespace jam {

namespace {

double mean_square_difference(const SizeDistribution& one, const SizeDistribution& other,
                              double from, double size_ratio) {
    constexpr int points = 2000;
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
        const double diameter = std::lerp(from, size_ratio, (i + 0.5) / points);
        const double difference = cumulative_fraction(one, Weight::volume, diameter) -
                                  cumulative_fraction(other, Weight::volume, diameter);
        sum += difference * difference;
    }
    return sum / points;
}

}  // namespace

double closest_alpha(double eta, double size_ratio, double reduced_from) {
    const SizeDistribution grains = GrainSizeDistribution{size_ratio, eta};
    check(grains);
    require(size_ratio > 1.0,
            "sizes.size_ratio = {}: must be above 1 to compare distributions; give the ratio at "
            "which they are compared",
            size_ratio);
    require(reduced_from >= 0.0 && reduced_from < 1.0,
            "reduced_from = {}: must be at least 0 and below 1; 0 compares all sizes",
            reduced_from);
    const double from = std::lerp(1.0, size_ratio, reduced_from);
    const auto difference = [&](double alpha) {
        return mean_square_difference(PowerLaw{size_ratio, alpha}, grains, from, size_ratio);
    };
    constexpr int bits = 26;  // half of a double's: a minimum cannot be located better
    return boost::math::tools::brent_find_minima(difference, -10.0, 10.0, bits).first;
}

}  // namespace jam
