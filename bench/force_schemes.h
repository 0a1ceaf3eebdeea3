// SPDX-License-Identifier: BSD-3-Clause
// Three other ways to sum contact forces with the same bits for any number of threads, to be held
// against the tiles of the library: colored cells, stored pair forces that are gathered, and a full
// list.
#pragma once

#include "contacts/contact_forces.h"
#include "core/lanes.h"
#include "neighbors/neighbor_list.h"

#include <vector>

namespace jam::bench {

/// What all of them share: the particles, and the near pairs by rows.
struct PairSystem {
    const PeriodicCell& cell;
    const Particles& particles;
    const NeighborList& pairs;  ///< half list
    Material material;
};

/// Sums that every scheme forms beside the loads, by block of rows and then in order.
struct PairSums {
    double energy = 0.0;
    Double4 virial_x{}, virial_y{}, virial_z{};  ///< columns of sum f r^T
    PairSums& operator+=(const PairSums& other);
};

/// Half list, loads written where they belong. Rows are cut into cells, runs of the (collection,
/// bin) order; two cells that touch a common particle have different colors, and colors go one
/// after the other.
class ColoredCells {
  public:
    explicit ColoredCells(const PairSystem& system);
    PairSums forces(const PairSystem& system, std::vector<Load>& loads) const;
    int color_count() const { return static_cast<int>(cells_of_color_.size()); }

  private:
    std::vector<std::vector<Count>> cells_of_color_;
};

/// Half list; every pair's force is stored, then each particle gathers its own by an index of the
/// pairs that list it.
class StoredPairForces {
  public:
    explicit StoredPairForces(const PairSystem& system);
    PairSums forces(const PairSystem& system, std::vector<Load>& loads);

  private:
    std::vector<Count> listed_begin_;    ///< by particle, into listed_
    std::vector<std::uint32_t> listed_;  ///< pairs in which the particle is the second
    std::vector<Load> pair_loads_;
};

/// Every pair from both sides; each particle sums its own row and writes to nobody else.
class FullList {
  public:
    explicit FullList(const PairSystem& system);
    PairSums forces(const PairSystem& system, std::vector<Load>& loads) const;

  private:
    NeighborList full_;
};

}  // namespace jam::bench
