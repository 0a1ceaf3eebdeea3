// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/bootstrap.h"

#include <algorithm>

namespace jam {

namespace {

double standard_deviation(std::span<const double> values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values) sum += value;
    double squares = 0.0;
    for (const double value : values) squares += (value - sum / n) * (value - sum / n);
    return std::sqrt(squares / (n - 1.0));
}

/// Of values in ascending order, between the nearest two.
double percentile(std::span<const double> ascending, double fraction) {
    const double place = fraction * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    const double part = place - static_cast<double>(below);
    return (1.0 - part) * ascending[below] + part * ascending[above];
}

}  // namespace

Estimate estimate_from_resamples(double value, Count count, std::vector<double> resampled) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (count < 2 || resampled.size() < 2) return {value, nan, nan, nan, count};
    std::sort(resampled.begin(), resampled.end());
    const auto n = static_cast<double>(count);
    return {value, standard_deviation(resampled) * std::sqrt(n / (n - 1.0)),
            percentile(resampled, 0.025), percentile(resampled, 0.975), count};
}

Estimate bootstrap_mean(std::span<const double> values, const BootstrapSettings& settings) {
    const auto mean = [&](std::span<const Index> chosen) {
        double sum = 0.0;
        for (const Index i : chosen) sum += values[i];
        return sum / static_cast<double>(chosen.size());
    };
    return bootstrap(static_cast<Index>(values.size()), mean, settings);
}

}  // namespace jam
