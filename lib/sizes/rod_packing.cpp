// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/rod_packing.h"

#include "core/check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <vector>

namespace jam {

// A line through the spheres meets each with probability ~ D^2, and cuts from it a chord D sqrt(u),
// u uniform in [0, 1]. The chords are the rods. They are packed on a ring, longest first.
namespace {

// Calls use(rod, item, fraction) for every rod in turn: rods are spread evenly over the items'
// cumulative weight, and rod number `rod` falls into `item` after `fraction` of its weight.
template <typename Use>
void spread_evenly(std::size_t rod_count, const std::vector<double>& weights, Use&& use) {
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::size_t item = 0;
    double before = 0.0;
    for (std::size_t rod = 0; rod < rod_count; ++rod) {
        const double target =
            (static_cast<double>(rod) + 0.5) / static_cast<double>(rod_count) * all;
        while (item + 1 < weights.size() && before + weights[item] <= target)
            before += weights[item++];
        use(rod, item, std::min(1.0, (target - before) / weights[item]));
    }
}

// Diameters at even steps of the surface: strata of equal volume, each of which has a surface
// ~ 1/D. Going through the volume needs no more of a distribution than its volume quantile.
std::vector<double> diameters_by_surface(const SizeDistribution& sizes, std::size_t count) {
    const double step = 1.0 / static_cast<double>(count);
    std::vector<double> surface(count);
    for (std::size_t i = 0; i < count; ++i)
        surface[i] = 1.0 / quantile(sizes, Weight::volume, (static_cast<double>(i) + 0.5) * step);
    std::vector<double> diameters(count);
    spread_evenly(count, surface, [&](std::size_t rod, std::size_t stratum, double fraction) {
        diameters[rod] =
            quantile(sizes, Weight::volume, (static_cast<double>(stratum) + fraction) * step);
    });
    return diameters;
}

std::vector<double> diameters_by_surface(std::span<const double> spheres, std::size_t count) {
    std::vector<double> sorted(spheres.begin(), spheres.end());
    std::ranges::sort(sorted);
    require(
        !sorted.empty() && sorted.front() > 0.0,
        "rod model: diameters must all be above zero, and at least one; give those of a packing");
    std::vector<double> surface(sorted.size());
    std::ranges::transform(sorted, surface.begin(), [](double d) { return d * d; });
    std::vector<double> diameters(count);
    spread_evenly(count, surface, [&](std::size_t rod, std::size_t sphere, double /*fraction*/) {
        diameters[rod] = sorted[sphere];
    });
    return diameters;
}

// Chords of ascending diameters, longest first. u runs through multiples of the golden ratio, which
// fill [0, 1] evenly over any stretch of diameters.
std::vector<double> rods_of(std::vector<double> diameters) {
    const double golden = (std::sqrt(5.0) - 1.0) / 2.0;
    for (std::size_t i = 0; i < diameters.size(); ++i) {
        const double turns = (static_cast<double>(i) + 0.5) * golden;
        diameters[i] *= std::sqrt(turns - std::floor(turns));
    }
    std::ranges::sort(diameters, std::greater{});
    return diameters;
}

// Farr and Groot (2009): each rod goes into the largest gap, against one of its sides, if that
// leaves f times the rod on both sides of it; otherwise the ring grows until it does.
double packed_fraction(const std::vector<double>& rods, double f) {
    std::priority_queue<double> gaps;
    gaps.push(f * rods.front());
    double gap_sum = f * rods.front();
    for (std::size_t i = 1; i < rods.size(); ++i) {
        const double rod = rods[i];
        const double gap = gaps.top();
        gaps.pop();
        const double rest = std::max(gap - rod - f * rod, f * rod);
        gaps.push(f * rod);
        gaps.push(rest);
        gap_sum += f * rod + rest - gap;
    }
    const double length = std::accumulate(rods.begin(), rods.end(), 0.0);
    return length / (length + gap_sum);
}

double fraction_of(std::vector<double> diameters, const RodModel& model) {
    return packed_fraction(rods_of(std::move(diameters)), model.gap_factor);
}

std::size_t checked_rod_count(const RodModel& model) {
    require(model.gap_factor > 0.0,
            "rod model: gap_factor = {}; must be above zero; 0.7654 by default", model.gap_factor);
    require(model.rod_count >= 1,
            "rod model: rod_count = {}; must be at least 1; 400000 by default", model.rod_count);
    return static_cast<std::size_t>(model.rod_count);
}

}  // namespace

double rod_packing_fraction(const SizeDistribution& sizes, const RodModel& model) {
    return fraction_of(diameters_by_surface(sizes, checked_rod_count(model)), model);
}

double rod_packing_fraction(std::span<const double> diameters, const RodModel& model) {
    return fraction_of(diameters_by_surface(diameters, checked_rod_count(model)), model);
}

}  // namespace jam
