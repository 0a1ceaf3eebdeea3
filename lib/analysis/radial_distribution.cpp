// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/radial_distribution.h"

#include "analysis/near_spheres.h"
#include "core/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jam {

namespace {

/// Counts of all pairs of classes, all bins; one block's share of them, or their sum.
struct PairCounts {
    std::vector<Count> counts;

    PairCounts& operator+=(const PairCounts& other) {
        if (counts.empty()) counts.resize(other.counts.size(), 0);
        for (std::size_t k = 0; k < other.counts.size(); ++k) counts[k] += other.counts[k];
        return *this;
    }
};

/// Place of the classes a <= b among the pairs, in the order 00, 01, .., 11, 12, ..
int pair_place(int a, int b, int classes) {
    return a * classes - a * (a - 1) / 2 + b - a;
}

Bins size_classes(const std::vector<double>& diameters, int classes) {
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    const double ratio = *largest / *smallest;
    if (!(ratio > 1.0)) return logarithmic_bins(*smallest, *largest, 1);
    Bins bins;
    for (int c = 0; c <= classes; ++c)
        bins.edges.push_back(*smallest * std::pow(ratio, static_cast<double>(c) / classes));
    bins.edges.back() = *largest;
    return bins;
}

/// Of the diameters of a class: their number and the sums of D, D^2, D^3.
using Moments = Eigen::Array4d;

std::vector<Moments> moments_of(const std::vector<double>& diameters,
                                const std::vector<int>& class_of, int classes) {
    std::vector<Moments> moments(classes, Moments::Zero());
    for (std::size_t i = 0; i < diameters.size(); ++i) {
        const double d = diameters[i];
        moments[class_of[i]] += Moments(1.0, d, d * d, d * d * d);
    }
    return moments;
}

/// Sum over pairs of two classes (each once) of ((D_i + D_j) / 2)^3.
double sum_of_cubes(const Moments& a, const Moments& b, bool same) {
    const double all = a[3] * b[0] + 3.0 * a[2] * b[1] + 3.0 * a[1] * b[2] + a[0] * b[3];
    return same ? 0.5 * (all - 8.0 * a[3]) / 8.0 : all / 8.0;
}

PairCounts count_pairs(const Packing& packing, const NearSphereList& near, const Bins& bins,
                       const std::vector<int>& class_of, int classes) {
    const auto pair_kinds = static_cast<std::size_t>(classes * (classes + 1) / 2);
    const auto bin_count = static_cast<std::size_t>(bins.count());
    const double bins_per_unit = static_cast<double>(bin_count) / bins.edges.back();
    return sum_blocks(near.row_count(), 8192, PairCounts{}, [&](Count begin, Count end) {
        PairCounts part{std::vector<Count>(pair_kinds * bin_count, 0)};
        near.for_each(begin, end, [&](const NearSpheres& pair) {
            const double diameters = packing.diameters[pair.first] + packing.diameters[pair.second];
            const double x = 2.0 * pair.apart.norm() / diameters;
            if (pair.first == pair.second || x >= bins.edges.back()) return;
            const auto [a, b] = std::minmax(class_of[pair.first], class_of[pair.second]);
            const auto kind = static_cast<std::size_t>(pair_place(a, b, classes));
            const auto bin = std::min(static_cast<std::size_t>(x * bins_per_unit), bin_count - 1);
            ++part.counts[kind * bin_count + bin];
        });
        return part;
    });
}

double largest_distance(const Packing& packing, const WrappedSpheres& wrapped, double wanted) {
    const double widest = *std::max_element(packing.diameters.begin(), packing.diameters.end());
    const double allowed = wrapped.cell.perpendicular_widths().minCoeff() / widest;
    require(allowed >= 1.0,
            "cell: narrower ({:.3g} of it) than the largest sphere; use a larger one", allowed);
    return std::min(wanted, allowed * (1.0 - 1e-9));
}

std::vector<double> over_expected(const std::vector<Count>& counts, const Bins& bins,
                                  double sum_of_cubed_diameters, double volume) {
    std::vector<double> values;
    for (int b = 0; b < bins.count(); ++b) {
        const double shell = std::pow(bins.edges[b + 1], 3) - std::pow(bins.edges[b], 3);
        const double expected =
            4.0 / 3.0 * std::numbers::pi * shell * sum_of_cubed_diameters / volume;
        values.push_back(expected > 0.0 ? static_cast<double>(counts[b]) / expected
                                        : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
}

}  // namespace

RadialDistribution radial_distribution(const Packing& packing,
                                       const RadialDistributionSettings& settings) {
    require(settings.size_classes >= 1 && settings.size_classes <= 8,
            "size classes: {} of them; give 1 to 8", settings.size_classes);
    require(settings.largest > 1.0, "largest distance: {}; give one above 1, where spheres touch",
            settings.largest);
    const WrappedSpheres wrapped = wrap_spheres(packing);
    const Bins class_bins = size_classes(packing.diameters, settings.size_classes);
    const int classes = class_bins.count();
    std::vector<int> class_of;
    for (const double diameter : packing.diameters) class_of.push_back(class_bins.bin_of(diameter));

    RadialDistribution result;
    result.class_bounds = class_bins.edges;
    const double largest = largest_distance(packing, wrapped, settings.largest);
    result.bins = linear_bins(0.0, largest, settings.bins);
    InteractionReach reach;
    reach.strain_margin = largest - 1.0;
    const PairCounts found =
        count_pairs(packing, NearSphereList(wrapped, reach), result.bins, class_of, classes);
    const std::vector<Moments> moments = moments_of(packing.diameters, class_of, classes);
    for (const Moments& of_class : moments)
        result.class_sizes.push_back(static_cast<Count>(of_class[0]));
    auto next = found.counts.begin();
    for (int a = 0; a < classes; ++a) {
        for (int b = a; b < classes; ++b, next += settings.bins) {
            RadialDistribution::Pair pair{a, b, {next, next + settings.bins}, {}};
            pair.values =
                over_expected(pair.counts, result.bins,
                              sum_of_cubes(moments[a], moments[b], a == b), packing.cell.volume());
            result.pairs.push_back(std::move(pair));
        }
    }
    return result;
}

Table table(const RadialDistribution& distribution) {
    Table result{{{"distance_low", distribution.bins.lower()},
                  {"distance_high", distribution.bins.upper()}}};
    for (const RadialDistribution::Pair& pair : distribution.pairs)
        result.columns.push_back(
            {fmt::format("g_{}_{}", pair.class_1 + 1, pair.class_2 + 1), pair.values});
    return result;
}

}  // namespace jam
