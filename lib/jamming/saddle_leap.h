// SPDX-License-Identifier: BSD-3-Clause
// Leaps away from saddles. Where the enthalpy has a direction that falls off slowly a relaxation
// creeps for as many steps as the square root of its curvature asks for, ever the same way: what it
// has gone is added again, many times at once (projective integration: Gear and Kevrekidis, SIAM J.
// Sci. Comput. 24, 1091, 2003).
#pragma once

#include "jamming/jam_state.h"

namespace jam {

/// The particles of now, to leap from later.
LeapReference leap_reference(const Particles& particles, double cundall);

/// Adds to the center of each particle in contact its displacement since the reference, so many
/// times that the one that goes farthest goes `longest` (Cartesian), or 50 times if that is less.
/// Returns how many times; 0 if nobody has moved. Lists are no longer valid.
double leap(const LeapReference& reference, const PeriodicCell& cell, double longest,
            Particles& particles);

}  // namespace jam
