// SPDX-License-Identifier: BSD-3-Clause
// Two levels of lists: candidates found by the search with a wide reach and seldom, and tiles
// filtered from them with a narrow one whenever the motion has used it up.
#pragma once

#include "neighbors/contact_tiles.h"
#include "neighbors/find_neighbors.h"
#include "neighbors/list_settings.h"
#include "neighbors/list_validity.h"

#include <span>

namespace jam {

/// The collections that lists with these settings have, for particles of these diameters.
SizeCollections list_collections(std::span<const double> diameters, const ListSettings& settings);

/// Scratch of a run: everything here can be made anew from the particles and `outer`.
struct VerletLists {
    VerletLists(std::span<const double> diameters, const ListSettings& settings);

    GridHierarchy hierarchy;
    ListSettings settings;
    double smallest_diameter;
    ListReference outer;
    ListReference inner;
    double outer_displacement = 0.0;  ///< of the particles since `outer`: no less than the largest
    double inner_displacement = 0.0;  ///< and since `inner`
    NeighborList candidates;
    ContactTiles tiles;
    Count searches = 0;
    Count refilters = 0;
    NeighborScratch neighbor_scratch;
    TileScratch tile_scratch;
};

/// How far a step moves things: the particle that goes farthest, and the cell.
struct StepMotion {
    double displacement = 0.0;  ///< within the cell, Cartesian
    double strain = 0.0;        ///< norm of the cell's
};

/// Searches anew at the particles' present places, to which a step has `moved` them, which sorts
/// and wraps them, and makes new tiles that outlast some steps of the `expected` motion.
void renew_lists(VerletLists& lists, const PeriodicCell& cell, const StepMotion& moved,
                 const StepMotion& expected, Particles& particles);

/// Makes the candidates again that an earlier search made at `outer`, for particles sorted as that
/// search left them, and new tiles: a run that goes on from a checkpoint has the same rows in the
/// same order.
void restore_lists(VerletLists& lists, const ListReference& outer, const PeriodicCell& cell,
                   const StepMotion& motion, Particles& particles);

enum class ListRenewal : std::uint8_t { none, tiles, search_needed };

/// Keeps the tiles valid for the particles' present places, to which a step has `moved` them:
/// leaves them, filters new ones from the candidates that outlast some steps of the `expected`
/// motion, or answers that only a search will do. Whether a search is needed does not depend on how
/// often tiles were made. How far particles have gone is measured only when the sum over the steps
/// has used the reach up.
ListRenewal keep_tiles_valid(VerletLists& lists, const PeriodicCell& cell, const StepMotion& moved,
                             const StepMotion& expected, Particles& particles);

}  // namespace jam
