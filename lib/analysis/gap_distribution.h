// SPDX-License-Identifier: BSD-3-Clause
// How far the backbone's particles are from touching more of their neighbors.
#pragma once

#include "analysis/bins.h"
#include "analysis/force_network.h"
#include "analysis/power_law_fit.h"
#include "analysis/table.h"

namespace jam {

struct GapDistributionSettings {
    int bins_per_decade = 10;
    double smallest = 1e-7;  ///< gaps below are counted in no bin
    double largest = 0.1;    ///< less in a cell too small for it
    /// The exponent is fitted to gaps up to this; from ten times the mean overlap, as near to
    /// contact as the packing is to its rigid limit.
    double fit_up_to = 0.03;
};

/// G(h): gaps h = 2 r / (D_i + D_j) - 1 > 0 of pairs of backbone particles, as pairs a particle and
/// unit of h, and gamma of G ~ h^-gamma at small gaps. Near jamming gamma = 0.41 is predicted
/// (Charbonneau et al., Phys. Rev. Lett. 114, 125504, 2015).
struct GapDistribution {
    Bins bins;  ///< of h
    std::vector<double> density;
    std::vector<Count> pair_counts;
    PowerLawFit small_gaps;  ///< exponent -gamma
};

/// Throws InputError as find_contacts does.
GapDistribution gap_distribution(const Packing& packing, const ForceNetwork& network,
                                 const GapDistributionSettings& settings = {});

/// Columns gap_low, gap_high, density, pairs.
Table table(const GapDistribution& distribution);

}  // namespace jam
