// SPDX-License-Identifier: BSD-3-Clause
// The periodic cell: a triclinic box in restricted form, a = (lx,0,0), b = (xy,ly,0), c =
// (xz,yz,lz), so that no rotation of the particles is ever needed.
#pragma once

#include "core/types.h"

#include <array>

namespace jam {

class PeriodicCell {
  public:
    /// Cubic unit cell.
    PeriodicCell() : PeriodicCell(Mat3::Identity()) {}

    /// Columns of `h` are the edge vectors a, b, c. Throws InputError unless h is finite, upper
    /// triangular, and has a positive diagonal.
    explicit PeriodicCell(const Mat3& h);

    static PeriodicCell cubic(double side);

    /// Columns are the edge vectors; upper triangular.
    const Mat3& matrix() const { return h_; }
    const Mat3& inverse() const { return inverse_; }
    double volume() const { return h_(0, 0) * h_(1, 1) * h_(2, 2); }
    bool is_orthogonal() const { return h_(0, 1) == 0.0 && h_(0, 2) == 0.0 && h_(1, 2) == 0.0; }

    Vec3 cartesian(const Vec3& fractional) const { return h_ * fractional; }
    Vec3 fractional(const Vec3& cartesian) const { return inverse_ * cartesian; }

    /// Distance between the two faces normal to each reciprocal direction.
    const Vec3& perpendicular_widths() const { return widths_; }

    /// The same lattice in other edges, tilts reduced: |xy|, |xz| <= lx/2 and |yz| <= ly/2.
    /// Fractional coordinates change by `change`: s' = change * s (an integer matrix).
    struct Reduction;
    Reduction reduced() const;
    bool is_reduced() const;

  private:
    Mat3 h_;
    Mat3 inverse_;
    Vec3 widths_;
};

struct PeriodicCell::Reduction {
    PeriodicCell cell;
    Mat3 change;
};

/// Fractional coordinates moved into [0, 1) each; never returns exactly 1.
Vec3 wrapped(const Vec3& fractional);

/// Smallest singular value of the deformation that takes `before` to `after`: the factor by which
/// it shortens the worst-placed distance.
double worst_shortening(const PeriodicCell& before, const PeriodicCell& after);

}  // namespace jam
