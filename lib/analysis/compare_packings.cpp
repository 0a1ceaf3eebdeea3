// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/compare_packings.h"

#include "core/check.h"

#include <algorithm>
#include <functional>
#include <string_view>

namespace jam {

namespace {

using Group = std::span<const PackingSummary>;

struct NamedNumber {
    std::string_view name;
    double (*value)(const PackingStatistics&);
};

constexpr NamedNumber numbers[] = {
    {"particle_count", [](const auto& s) { return static_cast<double>(s.particle_count); }},
    {"size_ratio", [](const auto& s) { return s.size_ratio; }},
    {"volume_fraction", [](const auto& s) { return s.volume_fraction; }},
    {"volume_fraction_nr", [](const auto& s) { return s.volume_fraction_nr; }},
    {"coordination", [](const auto& s) { return s.coordination; }},
    {"coordination_nr", [](const auto& s) { return s.coordination_nr; }},
    {"rattler_fraction", [](const auto& s) { return s.rattler_fraction; }},
    {"mean_pressure", [](const auto& s) { return s.pressure.trace() / 3.0; }},
    {"cundall", [](const auto& s) { return s.cundall; }},
    {"mean_overlap", [](const auto& s) { return s.mean_overlap; }},
    {"kinetic_energy_per_particle", [](const auto& s) { return s.kinetic_energy_per_particle; }},
};

struct NamedDistribution {
    std::string_view name;
    std::vector<double> PackingSummary::*values;
};

constexpr NamedDistribution distributions[] = {
    {"backbone_diameters", &PackingSummary::backbone_diameters},
    {"backbone_contact_counts", &PackingSummary::backbone_contact_counts},
    {"backbone_forces", &PackingSummary::backbone_forces},
    {"contact_larger_diameters", &PackingSummary::contact_larger_diameters},
    {"contact_size_ratios", &PackingSummary::contact_size_ratios},
};

std::vector<double> values_of(Group group, const NamedNumber& number) {
    std::vector<double> values;
    for (const PackingSummary& summary : group) values.push_back(number.value(summary.statistics));
    return values;
}

std::vector<double> pooled(Group group, const NamedDistribution& distribution) {
    std::vector<double> values;
    for (const PackingSummary& summary : group) {
        const std::vector<double>& more = summary.*distribution.values;
        values.insert(values.end(), more.begin(), more.end());
    }
    return values;
}

NumberComparison compare_number(const NamedNumber& number, Group a, Group b) {
    const std::vector<double> values_a = values_of(a, number);
    const std::vector<double> values_b = values_of(b, number);
    NumberComparison result;
    result.name = number.name;
    result.a = bootstrap_mean(values_a);
    result.b = bootstrap_mean(values_b);
    result.difference = result.b.value - result.a.value;
    result.p_value = mean_difference_p_value(values_a, values_b);
    return result;
}

}  // namespace

PackingSummary summarize(const Packing& packing, const ForceNetwork& network) {
    PackingSummary summary;
    summary.statistics = packing_statistics(packing, network);
    const double widest = *std::max_element(packing.diameters.begin(), packing.diameters.end());
    for (Index i = 0; i < network.rows.particle_count(); ++i) {
        if (network.rattlers.is_rattler[i] != 0) continue;
        summary.backbone_diameters.push_back(packing.diameters[i] / widest);
        summary.backbone_contact_counts.push_back(network.rattlers.contact_counts_nr[i]);
    }
    double sum = 0.0;
    for (const Contact& contact : network.contacts) {
        if (!network.rattlers.bears(contact)) continue;
        summary.backbone_forces.push_back(contact.force);
        const auto [smaller, larger] =
            std::minmax(packing.diameters[contact.first], packing.diameters[contact.second]);
        summary.contact_larger_diameters.push_back(larger / widest);
        summary.contact_size_ratios.push_back(smaller / larger);
        sum += contact.force;
    }
    const double mean = sum / static_cast<double>(summary.backbone_forces.size());
    for (double& force : summary.backbone_forces) force /= mean;
    return summary;
}

PackingComparison compare_packings(Group a, Group b) {
    require(!a.empty() && !b.empty(),
            "compare: a group has no packings; give at least one on each "
            "side");
    PackingComparison result;
    for (const NamedNumber& number : numbers)
        result.numbers.push_back(compare_number(number, a, b));
    for (const NamedDistribution& distribution : distributions) {
        std::vector<double> values_a = pooled(a, distribution);
        std::vector<double> values_b = pooled(b, distribution);
        if (values_a.empty() || values_b.empty()) continue;
        DistributionComparison comparison;
        comparison.name = distribution.name;
        comparison.count_a = static_cast<Count>(values_a.size());
        comparison.count_b = static_cast<Count>(values_b.size());
        comparison.difference = distribution_difference(std::move(values_a), std::move(values_b));
        result.distributions.push_back(std::move(comparison));
    }
    return result;
}

}  // namespace jam
