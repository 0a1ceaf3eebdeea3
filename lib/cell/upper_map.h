// SPDX-License-Identifier: BSD-3-Clause
// Fractional to Cartesian coordinates and back, for the hot loops.
#pragma once

#include "core/lanes.h"
#include "core/types.h"

namespace jam {

/// An upper triangular matrix applied to the first three of four numbers; the fourth becomes zero.
class UpperMap {
  public:
    explicit UpperMap(const Mat3& m)
        : x_{m(0, 0), 0.0, 0.0, 0.0},
          y_{m(0, 1), m(1, 1), 0.0, 0.0},
          z_{m(0, 2), m(1, 2), m(2, 2), 0.0} {}

    Double4 operator()(const Double4& v) const { return x_ * v[0] + y_ * v[1] + z_ * v[2]; }

    /// The same bits for four vectors at once.
    Columns4 operator()(const Columns4& v) const {
        return {x_[0] * v.x + y_[0] * v.y + z_[0] * v.z, y_[1] * v.y + z_[1] * v.z, z_[2] * v.z,
                Double4{}};
    }

  private:
    Double4 x_, y_, z_;
};

}  // namespace jam
