// SPDX-License-Identifier: BSD-3-Clause
// The spheres of a packing, found near each other by the grid search.
#pragma once

#include "core/parallel.h"
#include "grids/interaction_reach.h"
#include "neighbors/neighbor_list.h"
#include "packing/packing.h"
#include "particles/particles.h"

#include <vector>

namespace jam {

/// The spheres of a packing as the neighbor search wants them: the tilts of the cell reduced,
/// centers fractional in [0, 1). The place in the arrays is the packing's own.
struct WrappedSpheres {
    PeriodicCell cell;
    std::vector<Sphere> spheres;
};

/// Throws InputError if there are more particles than a neighbor list can name.
WrappedSpheres wrap_spheres(const Packing& packing);

/// Two near spheres: `first` < `second` in the packing's arrays, or a sphere and its own image, and
/// what takes the center of the second's image to that of the first:
/// apart = h (s_first - s_second - image).
struct NearSpheres {
    Index first;
    Index second;
    Image image;
    Vec3 apart;
};

/// Every pair within reach once, and some a little beyond it, in rows.
class NearSphereList {
  public:
    /// Throws InputError if the cell is narrower than the largest reach.
    NearSphereList(const WrappedSpheres& wrapped, const InteractionReach& reach);

    Count row_count() const { return static_cast<Count>(spheres_.size()); }
    Count pair_count() const { return list_.pair_count(); }

    /// Calls use(const NearSpheres&) for every pair of the rows [begin, end).
    template <typename Use>
    void for_each(Count begin, Count end, Use&& use) const {
        for (Count i = begin; i < end; ++i)
            for (const Neighbor neighbor : list_.row(static_cast<Index>(i)))
                use(pair(static_cast<Index>(i), neighbor));
    }

  private:
    NearSpheres pair(Index row, Neighbor neighbor) const;

    PeriodicCell cell_;
    std::vector<Sphere> spheres_;  ///< in the order of the search
    std::vector<Index> places_;    ///< of each in the packing
    NeighborList list_;
};

/// What collect(pair, items), which may append to `items`, gathers over all pairs; in an order that
/// does not depend on the number of threads.
template <typename Item, typename Collect>
std::vector<Item> gather_pairs(const NearSphereList& near, Collect&& collect) {
    constexpr Count rows_per_block = 4096;
    std::vector<std::vector<Item>> parts(block_count(near.row_count(), rows_per_block));
    for_each_block(near.row_count(), rows_per_block, [&](Count block, Count begin, Count end) {
        near.for_each(begin, end, [&](const NearSpheres& pair) { collect(pair, parts[block]); });
    });
    std::size_t count = 0;
    for (const auto& part : parts) count += part.size();
    std::vector<Item> items;
    items.reserve(count);
    for (auto& part : parts) {
        items.insert(items.end(), part.begin(), part.end());
        std::vector<Item>().swap(part);
    }
    return items;
}

}  // namespace jam
