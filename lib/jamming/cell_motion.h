// SPDX-License-Identifier: BSD-3-Clause
// How the cell may move, shared by all ways to jam.
#pragma once

#include "core/lanes.h"
#include "jamming/jam_state.h"

namespace jam {

/// What of a strain, or of its rate, the free components leave: nothing below the diagonal; no
/// tilt; or the trace alone.
Mat3 allowed_strain(const Mat3& strain, FreeCell free_cell);

/// The cell after a flow whose integral is `strain`, upper triangular; to second order.
PeriodicCell strained_cell(const PeriodicCell& cell, const Mat3& strain);

/// An upper triangular matrix applied to the first three of four numbers; the fourth becomes zero.
class UpperMap {
  public:
    explicit UpperMap(const Mat3& m)
        : x_{m(0, 0), 0.0, 0.0, 0.0},
          y_{m(0, 1), m(1, 1), 0.0, 0.0},
          z_{m(0, 2), m(1, 2), m(2, 2), 0.0} {}

    Double4 operator()(const Double4& v) const { return x_ * v[0] + y_ * v[1] + z_ * v[2]; }

  private:
    Double4 x_, y_, z_;
};

/// The same lattice in edges that are tilted less. Done with a search only, because it renumbers
/// images.
void reduce_tilt(JamState& state);

}  // namespace jam
