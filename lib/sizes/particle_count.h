// SPDX-License-Identifier: BSD-3-Clause
// How many particles a packing needs to show its distribution.
#pragma once

#include "core/particle_limit.h"
#include "sizes/size_distribution.h"

namespace jam {

/// Throws InputError naming "sizes.count" unless 1 <= count <= max_particle_count.
void check_particle_count(Count count);

/// The count when a scene names none.
///
/// Rule of Monti et al.: so many that at least 10 particles have D > 0.95 D_largest, here
/// N = 10.1 / P(D > 0.95 D_largest) rounded up, which gives the counts they state to 0.03 %. A
/// binary distribution is counted from large_count and f_S instead, a list of diameters by its
/// length. Throws InputError naming "sizes.count" if there is no rule (monodisperse) or if it asks
/// for more than max_particle_count.
Count particle_count(const SizeDistribution& sizes);

}  // namespace jam
