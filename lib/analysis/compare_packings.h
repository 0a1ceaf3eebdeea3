// SPDX-License-Identifier: BSD-3-Clause
// Two packings, or two groups of packings, side by side.
#pragma once

#include "analysis/bootstrap.h"
#include "analysis/packing_statistics.h"
#include "analysis/significance.h"

#include <span>
#include <string>
#include <vector>

namespace jam {

/// What a comparison needs of one packing; the packing itself may be gone.
struct PackingSummary {
    PackingStatistics statistics;
    std::vector<double> backbone_diameters;        ///< over the largest of all
    std::vector<double> backbone_contact_counts;   ///< of each particle of the backbone
    std::vector<double> backbone_forces;           ///< over their mean
    std::vector<double> contact_larger_diameters;  ///< over the largest of all, in the backbone
    std::vector<double> contact_size_ratios;       ///< smaller over larger, in the backbone
};
PackingSummary summarize(const Packing& packing, const ForceNetwork& network);

struct NumberComparison {
    std::string name;  ///< the key of `analyze_app stats --json`, or mean_pressure
    Estimate a;
    Estimate b;
    double difference = 0.0;  ///< b - a
    double p_value = 0.0;     ///< mean_difference_p_value; not a number for one against one
};

struct DistributionComparison {
    std::string name;
    DistributionDifference difference;  ///< pooled over each group
    Count count_a = 0;
    Count count_b = 0;
};

struct PackingComparison {
    std::vector<NumberComparison> numbers;
    std::vector<DistributionComparison> distributions;  ///< those that neither group lacks
};

/// Throws InputError if a group is empty.
PackingComparison compare_packings(std::span<const PackingSummary> a,
                                   std::span<const PackingSummary> b);

}  // namespace jam
