// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/power_law_fit.h"

#include "core/parallel.h"

#include <cmath>
#include <limits>

namespace jam {

namespace {

/// Sum and number of t over the values in the window.
struct LogSum {
    double sum = 0.0;
    Count count = 0;

    LogSum& operator+=(const LogSum& other) {
        sum += other.sum;
        count += other.count;
        return *this;
    }
};

/// Mean of t in [0, 1] with density ~ exp(-k t): 1/k - 1/(exp(k) - 1), with its series about k = 0.
double mean_of_cut_exponential(double k) {
    if (std::abs(k) < 1e-3) return 0.5 - k / 12.0;
    return 1.0 / k - 1.0 / std::expm1(k);
}

double variance_of_cut_exponential(double k) {
    if (std::abs(k) < 1e-2) return 1.0 / 12.0 - k * k / 240.0;
    const double s = 2.0 * std::sinh(0.5 * k);
    return 1.0 / (k * k) - 1.0 / (s * s);
}

/// The k that has this mean; the mean falls from 1 to 0 as k goes from -infinity to infinity.
double rate_with_mean(double mean) {
    double low = -700.0;
    double high = 700.0;
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = 0.5 * (low + high);
        (mean_of_cut_exponential(middle) > mean ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

PowerLawFit fit_power_law(std::span<const double> values, double low, double high) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto count = static_cast<Count>(values.size());
    const LogSum logs = sum_blocks(count, 4096, LogSum{}, [&](Count begin, Count end) {
        LogSum part;
        for (Count i = begin; i < end; ++i)
            if (values[i] >= low && values[i] <= high) part += {std::log(values[i] / low), 1};
        return part;
    });
    PowerLawFit fit{nan, nan, low, high, logs.count};
    if (logs.count == 0 || !(high > low)) return fit;
    const double range = std::log(high / low);
    const auto sample_size = static_cast<double>(logs.count);
    const double k = rate_with_mean(logs.sum / (sample_size * range));
    fit.exponent = -k / range - 1.0;
    fit.error = 1.0 / (range * std::sqrt(sample_size * variance_of_cut_exponential(k)));
    return fit;
}

}  // namespace jam
