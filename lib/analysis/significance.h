// SPDX-License-Identifier: BSD-3-Clause
// Whether two sets of numbers differ by more than chance.
#pragma once

#include "core/types.h"

#include <span>
#include <vector>

namespace jam {

/// Two-sided probability that two samples of one normal mean differ at least as much as these,
/// their variances free (Welch, 1947). One value against several is held against the scatter of the
/// several, as one more draw. Not a number for one against one: no scatter is known.
double mean_difference_p_value(std::span<const double> a, std::span<const double> b);

/// Largest distance of two cumulative distributions, and the probability of one at least as large
/// if both samples (each at least one value) come from one distribution (Kolmogorov and Smirnov,
/// with the small-sample correction of Stephens, 1970). Takes values as independent; for whole
/// numbers the probability is an upper bound.
struct DistributionDifference {
    double distance = 0.0;
    double p_value = 0.0;
};
DistributionDifference distribution_difference(std::vector<double> a, std::vector<double> b);

}  // namespace jam
