// SPDX-License-Identifier: BSD-3-Clause
// One grid for each collection, and the particles sorted by (collection, bin).
#pragma once

#include "cell/periodic_cell.h"
#include "core/parallel.h"
#include "grids/collection_grid.h"
#include "grids/interaction_reach.h"
#include "grids/size_collections.h"
#include "particles/particles.h"

#include <span>
#include <vector>

namespace jam {

/// Sorted particles as the search sees them: position relative to the center of their own bin and
/// share of the reach, in single precision. `reach` is rounded up by more than all errors of that
/// precision together, so that no near pair is missed.
struct LocalSpheres {
    std::vector<float> x, y, z, reach;
};

class GridHierarchy {
  public:
    explicit GridHierarchy(SizeCollections collections);

    const SizeCollections& collections() const { return collections_; }
    std::span<const CollectionGrid> grids() const { return grids_; }
    const LocalSpheres& local() const { return local_; }
    const PeriodicCell& cell() const { return cell_; }
    const InteractionReach& reach() const { return reach_; }

    /// Reorders the particles so that each collection is one range, in the order of ids within it.
    /// Done once, before the first sort.
    void group(Particles& particles) const;

    /// Adds to `graph` one task a collection that wraps its particles and sorts them by bin, from
    /// `particles` into `sorted`. Returns the tasks, by collection. `particles` must be grouped.
    /// Everything passed must outlive graph.run().
    std::vector<TaskGraph::Task> add_sorting(TaskGraph& graph, const PeriodicCell& cell,
                                             const InteractionReach& reach, Particles& particles,
                                             Particles& sorted);

  private:
    void sort_collection(int collection, Particles& particles, Particles& sorted);
    void place_bins(CollectionGrid& grid);
    void move_members(const CollectionGrid& grid, const Particles& particles, Particles& sorted);

    SizeCollections collections_;
    std::vector<CollectionGrid> grids_;
    LocalSpheres local_;
    PeriodicCell cell_;
    InteractionReach reach_;
    std::vector<Index> bin_of_particle_;
    std::vector<Index> order_;
};

}  // namespace jam
