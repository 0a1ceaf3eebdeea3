// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/force_distribution.h"

#include "analysis/static_stress.h"

#include <algorithm>

namespace jam {

namespace {

/// Forces of the contacts within the backbone, over their mean.
std::vector<double> scaled_forces(const ForceNetwork& network, double& mean_force) {
    std::vector<double> forces;
    double sum = 0.0;
    for (const Contact& contact : network.contacts) {
        if (!network.rattlers.bears(contact)) continue;
        forces.push_back(contact.force);
        sum += contact.force;
    }
    mean_force = forces.empty() ? 0.0 : sum / static_cast<double>(forces.size());
    for (double& force : forces) force /= mean_force;
    return forces;
}

}  // namespace

ForceDistribution force_distribution(const ForceNetwork& network,
                                     const ForceDistributionSettings& settings) {
    ForceDistribution result;
    const std::vector<double> forces = scaled_forces(network, result.mean_force);
    const auto [least, most] = std::minmax_element(forces.begin(), forces.end());
    result.bins = forces.empty() ? Bins{{0.0, 1.0}}
                                 : logarithmic_bins(*least, *most, settings.bins_per_decade);
    result.contact_counts.assign(result.bins.count(), 0);
    for (const double force : forces) ++result.contact_counts[result.bins.bin_of(force)];
    result.density = as_density(result.bins, result.contact_counts);
    const double fit_from = std::max(1e-4, 10.0 * cundall(network));
    result.small_forces = fit_power_law(forces, fit_from, settings.fit_up_to);
    return result;
}

Table table(const ForceDistribution& d) {
    return {{{"force_low", d.bins.lower()},
             {"force_high", d.bins.upper()},
             {"density", d.density},
             {"contacts", {d.contact_counts.begin(), d.contact_counts.end()}}}};
}

}  // namespace jam
