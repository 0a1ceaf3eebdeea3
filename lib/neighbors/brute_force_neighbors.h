// SPDX-License-Identifier: BSD-3-Clause
// Every near pair by trying all pairs through all images: slow, obvious, and the truth against
// which the grid search is held.
#pragma once

#include "cell/periodic_cell.h"
#include "neighbors/neighbor_list.h"
#include "particles/particles.h"

#include <span>
#include <tuple>
#include <vector>

namespace jam {

/// A pair in its one canonical form: first < second, or first == second and the first non-zero
/// component of `image` positive. The vector from second to first is
/// h (s_first - s_second - image).
struct NearPair {
    Index first;
    Index second;
    Image image;

    auto key() const { return std::tuple(first, second, image[0], image[1], image[2]); }
    friend bool operator==(const NearPair& a, const NearPair& b) { return a.key() == b.key(); }
    friend bool operator<(const NearPair& a, const NearPair& b) { return a.key() < b.key(); }
};

/// The canonical form of the pair seen from i: vector h (s_i - s_j - image).
NearPair canonical_pair(Index i, Index j, const Image& image);

/// All pairs with |h (s_i - s_j - image)| <= (D_i + D_j) / 2 (1 + strain_margin) + 2 skin over
/// images -1, 0, 1 along each edge, sorted; N^2 x 27 distances. `skin` is a length; centers are
/// wrapped into [0, 1). Throws InputError if the cell is narrower than the largest reach, where
/// these images would not be all.
std::vector<NearPair> brute_force_neighbors(const PeriodicCell& cell,
                                            std::span<const Sphere> spheres,
                                            double strain_margin = 0.0, double skin = 0.0);

/// The pairs of a list in canonical form, sorted; a pair listed twice stands twice.
std::vector<NearPair> canonical_pairs(const NeighborList& list);

}  // namespace jam
