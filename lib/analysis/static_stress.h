// SPDX-License-Identifier: BSD-3-Clause
// Stress and force balance of a packing at rest, from the elastic contact forces alone.
#pragma once

#include "analysis/force_network.h"

#include <span>

namespace jam {

/// P = (1 / V) sum_c f_c r_c n_c n_c^T, r_c the distance of the two centers (Love-Weber): the
/// internal pressure tensor, positive in compression. Units of stiffness / length (hooke).
Mat3 static_pressure(const Packing& packing, std::span<const Contact> contacts);

/// Sum of the elastic contact forces on a particle.
Vec3 net_force(const ForceNetwork& network, Index particle);

/// Cundall parameter C = sum_p |F_p| / sum_c |F_c|: net force over each particle, over the contact
/// forces, each contact once (Monti et al.). Not a number without contacts.
double cundall(const ForceNetwork& network);

/// The share of it that the backbone's particles have: rattlers not yet at rest are left out above,
/// all contacts stay below.
double cundall_nr(const ForceNetwork& network);

}  // namespace jam
