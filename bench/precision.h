// SPDX-License-Identifier: BSD-3-Clause
// How positions may be stored and compared, and what each way does to the forces of a packing.
#pragma once

#include "jamming/jam_state.h"
#include "neighbors/neighbor_list.h"

#include <string>
#include <vector>

namespace jam::bench {

struct PrecisionError {
    std::string representation;
    double force_error = 0.0;  ///< rms error of a pair's elastic force over the rms force
    Count wrong_contacts = 0;  ///< pairs that touch by one and not by the other
    Count contacts = 0;        ///< by long double
};

/// Elastic (hooke, k = 1) forces of all listed pairs by every representation, against long double
/// arithmetic on the stored double positions. Every overlap and gap is scaled by `scale` first,
/// through the second diameter of the pair: the same network at a pressure so much lower.
std::vector<PrecisionError> precision_errors(const PeriodicCell& cell, const Particles& particles,
                                             const NeighborList& pairs, double scale);

}  // namespace jam::bench
