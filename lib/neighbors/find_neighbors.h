// SPDX-License-Identifier: BSD-3-Clause
// The search for near pairs over a hierarchy of grids ("multi": Ogarko and Luding, 2012; Shire et
// al., 2021): each particle looks in its own collection and in those of larger particles, never in
// those of smaller ones, so that its cost does not grow with the size ratio.
#pragma once

#include "grids/grid_hierarchy.h"
#include "neighbors/fine_grid_search.h"
#include "neighbors/neighbor_list.h"
#include "neighbors/neighbor_method.h"

#include <span>
#include <vector>

namespace jam {

/// Words of found neighbors; what lies beyond `count` is room to write to.
struct FoundWords {
    std::vector<std::uint32_t> words;
    std::size_t count = 0;

    void reserve(std::size_t more) {
        if (words.size() < count + more) words.resize(count + more + words.size() / 2);
    }
    std::span<const std::uint32_t> span() const { return {words.data(), count}; }
};

/// Memory of the search, kept between searches.
struct NeighborScratch {
    Particles sorted;
    std::vector<std::vector<FoundWords>> found;  ///< by collection, then block of bins
    std::vector<Index> row_length;
    FineGridScratch fine_grid;  ///< of multi-old alone
};

/// The collections that a method sorts by: `chosen`, or for one_grid a single one.
SizeCollections collections_for(NeighborMethod method, const SizeCollections& chosen);

/// Sorts `particles` by (collection, bin), wrapping their centers, and lists every pair within
/// reach, and none farther apart than the reach plus the rounding of single precision. `particles`
/// must have been grouped by `hierarchy`. Throws InputError if the cell is narrower than the
/// largest reach.
///
/// Sorting of the collections and the searches run as one task graph: the search of a collection
/// starts when it and all larger ones are sorted.
///
/// `hierarchy` must have been made of collections_for(method, ...).
void find_candidates(GridHierarchy& hierarchy, const PeriodicCell& cell,
                     const InteractionReach& reach, Particles& particles, NeighborScratch& scratch,
                     NeighborList& candidates, NeighborMethod method = NeighborMethod::multi);

/// Keeps, of each row, the pairs within `reach`, tested in double precision at the particles'
/// present places in `cell`.
NeighborList within_reach(const NeighborList& candidates, const PeriodicCell& cell,
                          const InteractionReach& reach, const Particles& particles);

}  // namespace jam
