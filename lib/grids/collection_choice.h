// SPDX-License-Identifier: BSD-3-Clause
// Which collections make a search cheap: a model of its cost, and the least of it.
#pragma once

#include "grids/interaction_reach.h"
#include "grids/size_collections.h"

#include <span>

namespace jam {

/// What the pieces of a search cost, ns: fitted to the sweeps of bench_neighbors
/// (docs/performance.md). Only their ratios matter for the choice.
struct SearchCosts {
    double particle = 47.0;  ///< wrapped, sorted, moved, its row written
    double visit = 26.0;     ///< of one bin by another, its members pruned
    double vector = 2.2;     ///< sixteen candidates against one particle
};

/// Expected cost of a search, ns a particle, of spheres placed evenly in a cube at
/// `volume_fraction`.
double search_cost(std::span<const double> diameters, const SizeCollections& collections,
                   const InteractionReach& reach, double volume_fraction = 0.7,
                   const SearchCosts& costs = {});

/// Of geometric collections, one to as many as have a ratio of 1.5, those of the least cost.
SizeCollections cheapest_collections(std::span<const double> diameters,
                                     const InteractionReach& reach);

}  // namespace jam
