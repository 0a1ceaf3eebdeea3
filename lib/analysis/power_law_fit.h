// SPDX-License-Identifier: BSD-3-Clause
// The exponent of a power law, from values without bins.
#pragma once

#include "core/types.h"

#include <span>

namespace jam {

/// Density ~ x^exponent over [low, high]. Not a number where there is nothing to fit.
struct PowerLawFit {
    double exponent = 0.0;
    double error = 0.0;  ///< standard error, for independent values
    double low = 0.0;
    double high = 0.0;
    Count value_count = 0;  ///< values within [low, high]
};

/// Maximum likelihood of a power law cut off at both ends. With t = ln(x / low), L = ln(high / low)
/// and k = -(exponent + 1), the density of t is that of a cut-off exponential, and k solves
/// mean t = 1/k - L / (exp(kL) - 1). Values outside [low, high], both above zero, do not count.
PowerLawFit fit_power_law(std::span<const double> values, double low, double high);

}  // namespace jam
