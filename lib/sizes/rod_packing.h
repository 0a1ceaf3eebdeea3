// SPDX-License-Identifier: BSD-3-Clause
// The volume fraction to expect of a randomly jammed packing, from its diameters alone: the rod
// model of Farr and Groot, J. Chem. Phys. 131, 244104 (2009). Expect +-0.01 against simulations.
#pragma once

#include "sizes/size_distribution.h"

#include <span>

namespace jam {

struct RodModel {
    /// f: two rods keep a gap of f times the shorter one. 0.7654 is calibrated to random close
    /// packing of equal spheres, 0.6435; 0.780 gives 0.639, the value of Monti et al.
    double gap_factor = 0.7654;
    Count rod_count = 400'000;  ///< about +-2e-4 in the result
};

/// Predicted volume fraction.
double rod_packing_fraction(const SizeDistribution& sizes, const RodModel& model = {});

/// The same for spheres of these diameters, in any order. Throws InputError unless there is one and
/// all are above zero.
double rod_packing_fraction(std::span<const double> diameters, const RodModel& model = {});

}  // namespace jam
