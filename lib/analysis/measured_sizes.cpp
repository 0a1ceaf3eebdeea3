// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/measured_sizes.h"

#include "analysis/bins.h"
#include "particles/particles.h"

#include <algorithm>

namespace jam {

CumulativeVolume cumulative_volume(std::span<const double> diameters, int points_per_decade) {
    std::vector<double> ascending(diameters.begin(), diameters.end());
    std::sort(ascending.begin(), ascending.end());
    const double smallest = ascending.front();
    const double largest = ascending.back();
    CumulativeVolume result;
    result.diameters = largest > smallest
                           ? logarithmic_bins(smallest, largest, points_per_decade).edges
                           : std::vector<double>{largest};
    double below = 0.0;
    std::size_t next = 0;
    for (const double diameter : result.diameters) {
        for (; next < ascending.size() && ascending[next] <= diameter; ++next)
            below += sphere_volume(ascending[next]);
        result.fractions.push_back(below);
        const double range = largest - smallest;
        result.reduced.push_back(range > 0.0 ? (diameter - smallest) / range : 0.0);
    }
    for (double& fraction : result.fractions) fraction /= below;
    return result;
}

Table table(const CumulativeVolume& volume) {
    return {{{"diameter", volume.diameters},
             {"reduced_diameter", volume.reduced},
             {"volume_fraction_below", volume.fractions}}};
}

SizePowerLaw fit_sizes(std::span<const double> diameters) {
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    const PowerLawFit fit = fit_power_law(diameters, *smallest, *largest);
    return {-fit.exponent, 4.0 + fit.exponent, -fit.exponent - 1.0, fit.error};
}

}  // namespace jam
