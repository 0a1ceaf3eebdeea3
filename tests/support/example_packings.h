// SPDX-License-Identifier: BSD-3-Clause
// Packings for the tests of files: not jammed, but with something in every member.
#pragma once

#include "packing/packing.h"

namespace jam::test {

/// `size` spheres in a tilted cell, with velocities, shuffled ids above zero and every other member
/// set to something unlike its default.
Packing example_packing(Index size);

/// Fails the running test unless every bit of every member is the same.
void expect_same_bits(const Packing& packing, const Packing& expected);

}  // namespace jam::test
