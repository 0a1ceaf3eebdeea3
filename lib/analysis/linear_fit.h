// SPDX-License-Identifier: BSD-3-Clause
// A straight line through points with errors.
#pragma once

#include <span>

namespace jam {

/// y = intercept + slope x. Not a number where the points do not determine it.
struct LinearFit {
    double intercept = 0.0;
    double intercept_error = 0.0;
    double slope = 0.0;
    double slope_error = 0.0;
    double reduced_chi_squared = 0.0;  ///< of the residuals over the errors; 1 for a good fit
    int point_count = 0;
};

/// Least squares weighted by 1 / error^2 (all errors above zero, one length). Errors of the result
/// are standard errors, enlarged by the root of the reduced chi squared where that exceeds 1.
LinearFit fit_line(std::span<const double> x, std::span<const double> y,
                   std::span<const double> errors);

}  // namespace jam
