// SPDX-License-Identifier: BSD-3-Clause
// The search for near pairs over a hierarchy of grids ("multi": Ogarko and Luding, 2012; Shire et
// al., 2021): each particle looks in its own collection and in those of larger particles, never in
// those of smaller ones, so that its cost does not grow with the size ratio.
#pragma once

#include "grids/grid_hierarchy.h"
#include "neighbors/neighbor_list.h"

#include <vector>

namespace jam {

/// Memory of the search, kept between searches.
struct NeighborScratch {
    Particles sorted;
    std::vector<std::vector<std::vector<std::uint32_t>>>
        found;  ///< by collection, then block of bins
    std::vector<Index> row_length;
};

/// Sorts `particles` by (collection, bin), wrapping their centers, and lists every pair within
/// reach, and none farther apart than the reach plus the rounding of single precision. `particles`
/// must have been grouped by `hierarchy`. Throws InputError if the cell is narrower than the
/// largest reach.
///
/// Sorting of the collections and the searches run as one task graph: the search of a collection
/// starts when it and all larger ones are sorted.
void find_candidates(GridHierarchy& hierarchy, const PeriodicCell& cell,
                     const InteractionReach& reach, Particles& particles, NeighborScratch& scratch,
                     NeighborList& candidates);

/// Keeps, of each row, the pairs within `reach`, tested in double precision at the particles'
/// present places in `cell`.
NeighborList within_reach(const NeighborList& candidates, const PeriodicCell& cell,
                          const InteractionReach& reach, const Particles& particles);

}  // namespace jam
