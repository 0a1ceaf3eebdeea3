// SPDX-License-Identifier: BSD-3-Clause
// Small packings whose answers are known.
#pragma once

#include "packing/packing.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace jam::test {

/// A packing of the given spheres; ids 1..N, everything else by default.
Packing make_packing(const Mat3& edges_in_columns, std::vector<Vec3> positions,
                     std::vector<double> diameters);

/// `cells`^3 unit cells of side `lattice_constant`, spheres of one diameter.
Packing simple_cubic(int cells, double lattice_constant, double diameter);
Packing face_centered_cubic(int cells, double lattice_constant, double diameter);
/// A simple cubic crystal of 27 spheres with free surfaces: the outer layers have five contacts on
/// one side, and once they are gone so have the next ones.
Packing cubic_slab();

/// Restricted triclinic edges of volume about side^3, tilts up to half an edge.
Mat3 random_edges(double side, std::uint64_t seed);

/// Spheres at random points, with diameters in [1, size_ratio], log-uniform: overlaps at random.
Packing random_spheres(const Mat3& edges_in_columns, int count, double size_ratio,
                       std::uint64_t seed);

/// The same packing told otherwise: every position through `move`.
Packing moved(Packing packing, const std::function<Vec3(const Vec3&)>& move);

/// Particle i of the result is particle order[i] of `packing`.
Packing relabelled(const Packing& packing, const std::vector<Index>& order);

/// A permutation of 0..count-1.
std::vector<Index> shuffled(Index count, std::uint64_t seed);

}  // namespace jam::test
