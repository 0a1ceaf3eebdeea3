// SPDX-License-Identifier: BSD-3-Clause
// How the contact forces of the backbone are distributed.
#pragma once

#include "analysis/bins.h"
#include "analysis/force_network.h"
#include "analysis/power_law_fit.h"
#include "analysis/table.h"

namespace jam {

struct ForceDistributionSettings {
    int bins_per_decade = 10;
    /// The exponent is fitted to forces up to this, over the mean; from 1e-4, or ten times the
    /// Cundall parameter where that is more: below, a force is no larger than what is not in
    /// balance.
    double fit_up_to = 0.1;
};

/// P(f / f_mean) over the contacts within the backbone, and theta of P ~ f^theta at small forces.
/// Near jamming theta = 0.42 is predicted, and 0.17 for forces on particles that are held loosely
/// by their neighbors (Charbonneau et al., Phys. Rev. Lett. 114, 125504, 2015).
struct ForceDistribution {
    double mean_force = 0.0;  ///< f_mean
    Bins bins;                ///< of f / f_mean
    std::vector<double> density;
    std::vector<Count> contact_counts;
    PowerLawFit small_forces;  ///< exponent theta
};

/// Without contacts in the backbone: one empty bin and a fit that is not a number.
ForceDistribution force_distribution(const ForceNetwork& network,
                                     const ForceDistributionSettings& settings = {});

/// Columns force_low, force_high (over the mean), density, contacts.
Table table(const ForceDistribution& distribution);

}  // namespace jam
