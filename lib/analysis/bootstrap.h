// SPDX-License-Identifier: BSD-3-Clause
// Errors of whatever is averaged over packings, by drawing them again with replacement.
#pragma once

#include "core/parallel.h"
#include "core/random.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace jam {

struct BootstrapSettings {
    Count resamples = 2000;
    std::uint64_t seed = 1;
};

/// A value with its errors; these are not numbers for a single packing.
struct Estimate {
    double value = 0.0;
    double error = 0.0;  ///< standard error
    double low = 0.0;    ///< 95 % of the resamples lie between low and high
    double high = 0.0;
    Count count = 0;  ///< packings behind it
};

/// The resampled values, in any order, as the errors of `value`. The scatter among resamples of n
/// packings is too small by sqrt((n - 1) / n), which the standard error makes good (Efron, 1979).
Estimate estimate_from_resamples(double value, Count count, std::vector<double> resampled);

/// statistic(chosen) of all `count` packings, with errors: `chosen` (std::span<const Index>) names
/// the packings to take, some more than once. Must not depend on anything else.
template <typename Statistic>
Estimate bootstrap(Index count, Statistic&& statistic, const BootstrapSettings& settings = {}) {
    std::vector<Index> all(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) all[i] = i;
    const double value = statistic(std::span<const Index>(all));
    if (count < 2) return estimate_from_resamples(value, count, {});
    std::vector<double> resampled(static_cast<std::size_t>(settings.resamples));
    for_each_block(settings.resamples, 64, [&](Count, Count begin, Count end) {
        std::vector<Index> chosen(static_cast<std::size_t>(count));
        for (Count r = begin; r < end; ++r) {
            for (Index k = 0; k < count; ++k)
                chosen[k] = static_cast<Index>(
                    count * uniform(settings.seed, RandomStream::bootstrap,
                                    static_cast<std::uint64_t>(r), static_cast<std::uint32_t>(k)));
            resampled[r] = statistic(std::span<const Index>(chosen));
        }
    });
    return estimate_from_resamples(value, count, std::move(resampled));
}

/// The mean of `values` (at least one), one a packing, with its errors.
Estimate bootstrap_mean(std::span<const double> values, const BootstrapSettings& settings = {});

}  // namespace jam
