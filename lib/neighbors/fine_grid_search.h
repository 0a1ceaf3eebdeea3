// SPDX-License-Identifier: BSD-3-Clause
// The search of in 't Veld et al. (2008), "multi/old" in LAMMPS: one grid sized by the smallest
// collection for everybody, and for each pair of collections a stencil as wide as that pair
// reaches. Kept to be compared: each small particle walks through all bins in which a large one
// could be, and their number grows as lambda^3.
#pragma once

#include "grids/grid_hierarchy.h"
#include "neighbors/neighbor_list.h"

#include <cstdint>
#include <vector>

namespace jam {

/// Memory of the search, kept between searches.
struct FineGridScratch {
    CollectionGrid grid;
    std::vector<Index> bin_of_particle;
    std::vector<Index> order;                       ///< particles by bin, ascending within one
    std::vector<std::vector<std::uint32_t>> found;  ///< by block of particles
};

/// Words of the neighbors in the rows of the particles, which `hierarchy` has sorted, by blocks of
/// fine_grid_block rows; and the length of each row. Tested in double precision.
void search_fine_grid(const GridHierarchy& hierarchy, const Particles& particles,
                      FineGridScratch& scratch, std::vector<Index>& row_length);

inline constexpr Count fine_grid_block = 1024;

}  // namespace jam
