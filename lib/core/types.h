// SPDX-License-Identifier: BSD-3-Clause
// The number types every other folder speaks in.
//
// Units throughout the library: stiffness k = 1, smallest diameter 1, material density 1, unless a
// scene says otherwise; nothing in the code depends on that choice.
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace jam {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// The place of a particle in the arrays; at most 2^27 of them (neighbor_list.h says why).
using Index = std::int32_t;

/// How many of something: pairs, steps, bytes.
using Count = std::int64_t;

/// Periodic image: the cell vectors to add, as whole numbers.
using Image = Eigen::Matrix<std::int8_t, 3, 1>;

}  // namespace jam
