// SPDX-License-Identifier: BSD-3-Clause
// Collections: the intervals of diameter that each get a grid of their own.
#pragma once

#include "core/types.h"

#include <span>
#include <vector>

namespace jam {

/// Ascending intervals (upper[c-1], upper[c]] of diameter; every one holds a particle.
struct SizeCollections {
    std::vector<double>
        upper;  ///< largest diameter of each collection, as found among the particles
    std::vector<Index> begin;  ///< size C + 1: where each begins once particles are grouped by it

    int count() const { return static_cast<int>(upper.size()); }
};

struct CollectionSettings {
    /// Largest over smallest diameter within a collection. About 4 is the best trade between a
    /// short loop over grids and few useless candidates (docs/performance.md has the sweep).
    double ratio = 4.0;
};

/// Geometric intervals over the range of `diameters` (length N >= 1, all above zero), as many as
/// the ratio asks for; intervals that hold no particle are left out.
SizeCollections geometric_collections(std::span<const double> diameters,
                                      const CollectionSettings& settings = {});

/// `intervals` equal steps of diameter instead (Monti et al., Fig. 11).
SizeCollections linear_collections(std::span<const double> diameters, int intervals);

/// Collections with the given inner bounds (ascending); empty ones are left out.
SizeCollections collections_between(std::span<const double> diameters,
                                    std::span<const double> bounds);

/// The collection that a diameter belongs to.
int collection_of(const SizeCollections& collections, double diameter);

}  // namespace jam
