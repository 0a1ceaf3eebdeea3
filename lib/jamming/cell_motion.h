// SPDX-License-Identifier: BSD-3-Clause
// How the cell may move, shared by all ways to jam.
#pragma once

#include "jamming/jam_state.h"

namespace jam {

/// What of a strain, or of its rate, the free components leave: nothing below the diagonal; no
/// tilt; or the trace alone.
Mat3 allowed_strain(const Mat3& strain, FreeCell free_cell);

/// The cell after a flow whose integral is `strain`, upper triangular; to second order.
PeriodicCell strained_cell(const PeriodicCell& cell, const Mat3& strain);

/// The same lattice in edges that are tilted less. Done with a search only, because it renumbers
/// images.
void reduce_tilt(JamState& state);

}  // namespace jam
