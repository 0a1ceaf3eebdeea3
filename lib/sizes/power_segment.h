// SPDX-License-Identifier: BSD-3-Clause
// Integrals of a power over an interval, accurate at and about the exponents where the textbook
// forms divide zero by zero: everything is written through expm1 and log1p of p ln(b/a).
#pragma once

#include <cmath>

namespace jam {

/// Integral of x^(p - 1) from a to b, 0 < a <= b; ln(b/a) at p = 0.
inline double power_integral(double p, double a, double b) {
    const double log_ratio = std::log(b / a);
    const double y = p * log_ratio;
    return std::pow(a, p) * log_ratio * (y == 0.0 ? 1.0 : std::expm1(y) / y);
}

/// power_integral(p, a, x) / power_integral(p, a, b) for a <= x <= b, a < b.
inline double power_fraction(double p, double a, double b, double x) {
    const double end = p * std::log(b / a);
    if (end == 0.0) return std::log(x / a) / std::log(b / a);
    return std::expm1(p * std::log(x / a)) / std::expm1(end);
}

/// The x at which power_fraction(p, a, b, x) = fraction; a at 0 and b at 1, exactly. Measured from
/// the nearer end, since next to b the fraction alone no longer tells x apart from b.
inline double power_quantile(double p, double a, double b, double fraction) {
    if (fraction > 0.5) return power_quantile(p, b, a, 1.0 - fraction);
    const double log_ratio = std::log(b / a);
    const double y = p * log_ratio;
    const double along = y == 0.0 ? fraction : std::log1p(fraction * std::expm1(y)) / y;
    return a * std::exp(along * log_ratio);
}

}  // namespace jam
