// SPDX-License-Identifier: BSD-3-Clause
// Which sizes touch which.
#pragma once

#include "analysis/bins.h"
#include "analysis/contact_network.h"
#include "analysis/table.h"

#include <span>

namespace jam {

/// Joint probability density P_c(D1, D2), D1 >= D2, that a contact is between particles of these
/// diameters, normalised over the triangle D2 <= D1, and the conditional one
/// P_c(D1, D2) / P(D = D1), P the density of all particles' diameters (Monti et al., Fig. 4). On
/// logarithmic bins; matrices have one row a bin of D1 and hold zero where D2 is in a larger bin.
struct ContactPairSizes {
    Bins bins;
    Eigen::MatrixXd joint;
    Eigen::MatrixXd conditional;
    Eigen::Matrix<Count, Eigen::Dynamic, Eigen::Dynamic> contact_counts;

    /// Diameters (geometric middle of the bins) of the most probable pair, {D1, D2}.
    std::pair<double, double> most_probable() const;
};

ContactPairSizes contact_pair_sizes(std::span<const double> diameters,
                                    std::span<const Contact> contacts, int bins_per_decade = 20);

/// Columns diameter_1_low, diameter_1_high, diameter_2_low, diameter_2_high, joint, conditional,
/// contacts; a row a pair of bins with D2 <= D1.
Table table(const ContactPairSizes& sizes);

}  // namespace jam
