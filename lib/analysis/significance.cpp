// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/significance.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

namespace {

struct MeanAndVariance {
    double mean = 0.0;
    double variance = 0.0;  ///< of the values; 0 for a single one
    double count = 0.0;
};

MeanAndVariance describe(std::span<const double> values) {
    MeanAndVariance result;
    result.count = static_cast<double>(values.size());
    for (const double value : values) result.mean += value / result.count;
    if (values.size() < 2) return result;
    for (const double value : values)
        result.variance += (value - result.mean) * (value - result.mean) / (result.count - 1.0);
    return result;
}

double two_sided(double difference, double standard_error, double degrees_of_freedom) {
    if (standard_error == 0.0) return difference == 0.0 ? 1.0 : 0.0;
    const double t = std::abs(difference) / standard_error;
    if (!std::isfinite(t)) return std::numeric_limits<double>::quiet_NaN();
    const boost::math::students_t distribution(degrees_of_freedom);
    return 2.0 * boost::math::cdf(boost::math::complement(distribution, t));
}

/// Probability that Kolmogorov's variable exceeds x: 2 sum_k (-1)^(k-1) exp(-2 k^2 x^2).
double kolmogorov_tail(double x) {
    if (x < 0.2) return 1.0;  // 1 to within 1e-12, where the series converges slowly
    double sum = 0.0;
    for (int k = 1; k <= 100; ++k) {
        const double term = std::exp(-2.0 * k * k * x * x);
        sum += k % 2 == 1 ? term : -term;
        if (term < 1e-18) break;
    }
    return std::clamp(2.0 * sum, 0.0, 1.0);
}

}  // namespace

double mean_difference_p_value(std::span<const double> a, std::span<const double> b) {
    const MeanAndVariance first = describe(a);
    const MeanAndVariance second = describe(b);
    const double difference = first.mean - second.mean;
    if (first.count < 2.0 && second.count < 2.0) return std::numeric_limits<double>::quiet_NaN();
    if (first.count < 2.0 || second.count < 2.0) {
        const MeanAndVariance& several = first.count < 2.0 ? second : first;
        const double error = std::sqrt(several.variance * (1.0 + 1.0 / several.count));
        return two_sided(difference, error, several.count - 1.0);
    }
    const double u = first.variance / first.count;
    const double v = second.variance / second.count;
    const double degrees =
        u + v == 0.0
            ? 1.0
            : (u + v) * (u + v) / (u * u / (first.count - 1.0) + v * v / (second.count - 1.0));
    return two_sided(difference, std::sqrt(u + v), degrees);
}

DistributionDifference distribution_difference(std::vector<double> a, std::vector<double> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    const auto count_a = static_cast<double>(a.size());
    const auto count_b = static_cast<double>(b.size());
    double distance = 0.0;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        const double x = std::min(a[i], b[j]);
        while (i < a.size() && a[i] == x) ++i;
        while (j < b.size() && b[j] == x) ++j;
        distance = std::max(distance, std::abs(static_cast<double>(i) / count_a -
                                               static_cast<double>(j) / count_b));
    }
    const double root = std::sqrt(count_a * count_b / (count_a + count_b));
    return {distance, kolmogorov_tail((root + 0.12 + 0.11 / root) * distance)};
}

}  // namespace jam
