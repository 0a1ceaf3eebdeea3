// SPDX-License-Identifier: BSD-3-Clause
// Intervals of a histogram.
#pragma once

#include "core/types.h"

#include <cstddef>
#include <vector>

namespace jam {

/// Bin b holds edges[b] <= x < edges[b + 1]; the last one holds its upper edge too.
struct Bins {
    std::vector<double> edges;  ///< strictly ascending, one more than there are bins

    int count() const { return static_cast<int>(edges.size()) - 1; }
    /// Bin of x; -1 outside.
    int bin_of(double x) const;
    double width(int bin) const { return edges[bin + 1] - edges[bin]; }

    std::vector<double> lower() const { return {edges.begin(), edges.end() - 1}; }
    std::vector<double> upper() const { return {edges.begin() + 1, edges.end()}; }
};

/// Equal steps of log x from `low` > 0 to `high`, about `per_decade` of them to a factor of ten.
/// One bin of no width to speak of if low == high.
Bins logarithmic_bins(double low, double high, int per_decade);

/// `count` equal steps.
Bins linear_bins(double low, double high, int count);

/// Counts as a density over x: sum of density times width is 1. All zero if nothing was counted.
std::vector<double> as_density(const Bins& bins, const std::vector<Count>& counts);

}  // namespace jam
