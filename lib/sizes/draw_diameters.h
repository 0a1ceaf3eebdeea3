// SPDX-License-Identifier: BSD-3-Clause
// The diameters of one packing, drawn from a distribution.
#pragma once

#include "sizes/particle_count.h"
#include "sizes/size_distribution.h"

#include <cstdint>
#include <vector>

namespace jam {

enum class DrawMethod {
    stratified,  ///< D_i at number quantile (i + 1/2) / N: no randomness, ascending, the default
    random,      ///< D_i at a random number quantile, from seed and id
};

/// `count` diameters; the index is the particle's id. Stratified, `count` from particle_count
/// gives: at least 10 above 0.95 of the largest where that rule is used, the exact numbers of small
/// and large spheres for a binary distribution, each diameter once for a list. The same for any
/// thread count. Throws InputError as check_particle_count.
std::vector<double> draw_diameters(const SizeDistribution& sizes, Count count,
                                   DrawMethod method = DrawMethod::stratified,
                                   std::uint64_t seed = 0);

}  // namespace jam
