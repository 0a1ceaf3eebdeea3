// SPDX-License-Identifier: BSD-3-Clause
#include "report/packing_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace jam {

namespace {

SizesName power_law_name(const PowerLaw& law) {
    return {fmt::format("λ = {:g}, α = {:.4g}", law.size_ratio, law.alpha), law};
}

struct Words {
    SizesName operator()(const PowerLaw& law) const { return power_law_name(law); }
    SizesName operator()(const Binary& sizes) const {
        return {
            fmt::format("two sizes, λ = {:g}, f_S = {:g}", sizes.size_ratio, sizes.small_fraction),
            {}};
    }
    SizesName operator()(const Monodisperse&) const { return {"equal spheres", {}}; }
    SizesName operator()(const GrainSizeDistribution& sizes) const {
        return {fmt::format("grain sizes, λ = {:g}, η = {:g}", sizes.size_ratio, sizes.eta), {}};
    }
    SizesName operator()(const Lognormal& sizes) const {
        return {fmt::format("lognormal, σ = {:g}", sizes.sigma), {}};
    }
    SizesName operator()(const DiameterList&) const { return {"sizes from a list", {}}; }
    SizesName operator()(const CumulativeCurve&) const { return {"sizes from a curve", {}}; }
};

double rounded_to(int digits, double number) {
    const double unit = std::pow(10.0, std::floor(std::log10(number)) + 1.0 - digits);
    return unit * std::round(number / unit);
}

/// The size ratio that a packing was made for: a little above the one found, since nothing makes
/// the largest particle drawn the largest that could have been.
double nominal_size_ratio(double found) {
    for (const int digits : {1, 2}) {
        const double rounded = rounded_to(digits, found);
        if (rounded > 0.998 * found && rounded < 1.03 * found) return rounded;
    }
    return rounded_to(3, found);
}

/// Largest distance between the measured cumulative volume and that of the law.
double distance_to_law(const CumulativeVolume& volume, const PowerLaw& law) {
    double largest = 0.0;
    const double smallest_diameter = volume.diameters.front();
    for (std::size_t k = 0; k < volume.diameters.size(); ++k) {
        const double expected = cumulative_fraction(
            law, Weight::volume,
            std::clamp(volume.diameters[k] / smallest_diameter, 1.0, law.size_ratio));
        largest = std::max(largest, std::abs(volume.fractions[k] - expected));
    }
    return largest;
}

/// A quantity of one packing that is averaged over the packings of a group.
struct Averaged {
    const char* name;
    Estimate PackingGroup::*estimate;
    double (*value)(const Measurements&);
};

constexpr std::array<Averaged, 6> averaged = {{
    {"volume_fraction", &PackingGroup::volume_fraction,
     [](const Measurements& m) { return m.statistics.volume_fraction; }},
    {"volume_fraction_nr", &PackingGroup::volume_fraction_nr,
     [](const Measurements& m) { return m.statistics.volume_fraction_nr; }},
    {"coordination", &PackingGroup::coordination,
     [](const Measurements& m) { return m.statistics.coordination; }},
    {"coordination_nr", &PackingGroup::coordination_nr,
     [](const Measurements& m) { return m.statistics.coordination_nr; }},
    {"rattler_fraction", &PackingGroup::rattler_fraction,
     [](const Measurements& m) { return m.statistics.rattler_fraction; }},
    {"onset", &PackingGroup::onset, [](const Measurements& m) { return m.backbone_sizes.onset; }},
}};

/// Power laws before others, then by size ratio, alpha and words.
auto rank(const SizesName& sizes) {
    const PowerLaw law = sizes.law.value_or(PowerLaw{0.0, 0.0});
    return std::tuple(!sizes.law.has_value(), law.size_ratio, law.alpha, sizes.words);
}

}  // namespace

SizesName name_of(const SizeDistribution& sizes) {
    return std::visit(Words{}, sizes);
}

SizesName name_of(const Measurements& m) {
    if (!m.polydisperse()) return name_of(SizeDistribution{Monodisperse{}});
    const PowerLaw law{nominal_size_ratio(m.statistics.size_ratio),
                       std::round(20.0 * m.power_law.alpha) / 20.0};
    const bool in_range = law.alpha > min_alpha && law.alpha < max_alpha && law.size_ratio > 1.0;
    if (in_range && distance_to_law(m.cumulative_volume, law) < 0.05) return power_law_name(law);
    return {fmt::format("other sizes, λ = {:.3g}", m.statistics.size_ratio), {}};
}

std::vector<PackingGroup> group_packings(std::span<const NamedMeasurements> packings) {
    std::map<std::string, PackingGroup> by_words;
    for (std::size_t i = 0; i < packings.size(); ++i) {
        PackingGroup& group = by_words[packings[i].sizes.words];
        group.sizes = packings[i].sizes;
        group.members.push_back(static_cast<int>(i));
    }
    std::vector<PackingGroup> groups;
    for (auto& [words, group] : by_words) {
        for (const Averaged& quantity : averaged) {
            std::vector<double> values;
            for (const int i : group.members)
                values.push_back(quantity.value(packings[i].measurements));
            group.*quantity.estimate = bootstrap_mean(values);
        }
        groups.push_back(std::move(group));
    }
    std::ranges::sort(groups, {}, [](const PackingGroup& group) { return rank(group.sizes); });
    return groups;
}

Table groups_table(std::span<const PackingGroup> groups) {
    Table table{{{"size_ratio", {}}, {"alpha", {}}, {"packings", {}}}};
    for (const Averaged& quantity : averaged) {
        table.columns.push_back({quantity.name, {}});
        table.columns.push_back({std::string(quantity.name) + "_error", {}});
    }
    for (const PackingGroup& group : groups) {
        if (!group.sizes.law) continue;
        std::vector<double> row = {group.sizes.law->size_ratio, group.sizes.law->alpha,
                                   static_cast<double>(group.members.size())};
        for (const Averaged& quantity : averaged) {
            row.push_back((group.*quantity.estimate).value);
            row.push_back((group.*quantity.estimate).error);
        }
        for (std::size_t c = 0; c < row.size(); ++c) table.columns[c].values.push_back(row[c]);
    }
    return table;
}

}  // namespace jam
