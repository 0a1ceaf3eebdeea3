// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/backbone_sizes.h"

#include "core/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

namespace {

std::vector<double> sorted_backbone(std::span<const double> diameters, const Rattlers& rattlers) {
    std::vector<double> backbone;
    for (std::size_t i = 0; i < diameters.size(); ++i)
        if (rattlers.is_rattler[i] == 0) backbone.push_back(diameters[i]);
    std::sort(backbone.begin(), backbone.end());
    return backbone;
}

std::vector<Count> counts_in(const Bins& bins, std::span<const double> values) {
    std::vector<Count> counts(bins.count(), 0);
    for (const double value : values) ++counts[bins.bin_of(value)];
    return counts;
}

double fraction_above(std::span<const double> ascending, double x) {
    const auto above = ascending.end() - std::upper_bound(ascending.begin(), ascending.end(), x);
    return static_cast<double>(above) / static_cast<double>(ascending.size());
}

/// The smallest diameter D for which less than `threshold` of them are above D. F falls only at the
/// diameters themselves, and equal ones fall together.
double onset_diameter(std::span<const double> ascending, double threshold) {
    const auto below = std::partition_point(ascending.begin(), ascending.end(), [&](double x) {
        return fraction_above(ascending, x) >= threshold;
    });
    return *below;
}

}  // namespace

BackboneSizes backbone_sizes(std::span<const double> diameters, const Rattlers& rattlers,
                             const BackboneSizesSettings& settings) {
    require(settings.onset_threshold > 0.0 && settings.onset_threshold < 1.0,
            "onset threshold: {} is not between 0 and 1; the paper takes 0.99",
            settings.onset_threshold);
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    const std::vector<double> backbone = sorted_backbone(diameters, rattlers);
    BackboneSizes result;
    result.bins = logarithmic_bins(*smallest, *largest, settings.bins_per_decade);
    result.density = as_density(result.bins, counts_in(result.bins, diameters));
    result.density_nr = as_density(result.bins, counts_in(result.bins, backbone));
    for (const double edge : result.bins.edges)
        result.larger_nr.push_back(backbone.empty() ? 0.0 : fraction_above(backbone, edge));
    result.onset = backbone.empty() ? std::numeric_limits<double>::quiet_NaN()
                                    : onset_diameter(backbone, settings.onset_threshold) / *largest;
    result.effective_size_ratio = 1.0 / result.onset;
    return result;
}

Table density_table(const BackboneSizes& sizes) {
    return {{{"diameter_low", sizes.bins.lower()},
             {"diameter_high", sizes.bins.upper()},
             {"density", sizes.density},
             {"density_nr", sizes.density_nr}}};
}

Table larger_table(const BackboneSizes& sizes) {
    Table result{{{"scaled_diameter", sizes.bins.edges}, {"larger_nr", sizes.larger_nr}}};
    for (double& edge : result.columns[0].values) edge /= sizes.bins.edges.back();
    return result;
}

}  // namespace jam
