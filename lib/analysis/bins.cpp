// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/bins.h"

#include "core/check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace jam {

int Bins::bin_of(double x) const {
    if (!(x >= edges.front() && x <= edges.back())) return -1;
    const auto above = std::upper_bound(edges.begin(), edges.end(), x);
    return std::min(static_cast<int>(above - edges.begin()), count()) - 1;
}

Bins logarithmic_bins(double low, double high, int per_decade) {
    require(
        low > 0.0 && high >= low && per_decade > 0,
        "logarithmic bins: from {} to {} in {} steps a decade; both ends must be above zero and "
        "in order",
        low, high, per_decade);
    const int count =
        std::max(1, static_cast<int>(std::lround(std::log10(high / low) * per_decade)));
    Bins bins;
    for (int b = 0; b <= count; ++b)
        bins.edges.push_back(low * std::pow(high / low, static_cast<double>(b) / count));
    bins.edges.back() = std::max(high, std::nextafter(low, 2.0 * low));
    return bins;
}

Bins linear_bins(double low, double high, int count) {
    require(high > low && count > 0, "bins: {} of them from {} to {}; give at least one, in order",
            count, low, high);
    Bins bins;
    for (int b = 0; b <= count; ++b) bins.edges.push_back(low + (high - low) * b / count);
    bins.edges.back() = high;
    return bins;
}

std::vector<double> as_density(const Bins& bins, const std::vector<Count>& counts) {
    const auto total = std::accumulate(counts.begin(), counts.end(), Count{0});
    std::vector<double> density(counts.size(), 0.0);
    if (total == 0) return density;
    for (int b = 0; b < bins.count(); ++b)
        density[b] = static_cast<double>(counts[b]) / (static_cast<double>(total) * bins.width(b));
    return density;
}

}  // namespace jam
