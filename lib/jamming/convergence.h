// SPDX-License-Identifier: BSD-3-Clause
// Is the packing jammed? The criteria of Monti et al., Methods, each with the tolerance of the
// scene.
#pragma once

#include "analysis/packing_statistics.h"
#include "jamming/jam_state.h"
#include "jamming/scene.h"
#include "jamming/verdict.h"

namespace jam {

/// Everything that is measured of a state at a record. The packing is the one that would be saved,
/// and every number is evaluated on it.
struct Measurement {
    Packing packing;
    ForceNetwork network;
    PackingStatistics statistics;
};

Measurement measure(const JamState& state, const Scene& scene);

/// Contacts above isostaticity of the network of particles that four contacts or more hold: three
/// hold nothing where there is no friction, and a rattler that is pushed along may well have three.
Count excess_contact_count_of_held(const Packing& packing);

/// Adds the measurement to the state's samples and drops those that no window needs any more.
void take_sample(const Measurement& measurement, const StopSettings& stop, JamState& state);

/// Criteria by the names of their tolerances in the scene; a window that is not yet full holds
/// nothing. A quasi-static run is judged by pressure, Cundall parameter, contacts that miss to
/// isostaticity, and stability of the backbone (up to 60,000 particles in a cell free in all
/// components: its particles with four contacts or more and, if these give way, all of it; an
/// eigenvalue below -5e-3 p D is unstable, D the mean diameter of these particles).
/// Where stability is not asked for it reads unknown, and does not hold.
Verdict judge(const Measurement& measurement, const JamState& state, const Scene& scene,
              bool ask_stability = true);

/// Largest |P_int - P_a| of the six components over the mean of P_a; of the components that the
/// cell is free to answer to.
double pressure_error(const Mat3& internal, const ProtocolSettings& protocol);

}  // namespace jam
