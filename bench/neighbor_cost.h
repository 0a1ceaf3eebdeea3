// SPDX-License-Identifier: BSD-3-Clause
// What one build of a neighbor list costs, beside one force evaluation: the sweeps of
// bench_neighbors.
#pragma once

#include "jamming/jam_state.h"
#include "neighbors/neighbor_method.h"

#include <optional>
#include <string>
#include <vector>

namespace jam::bench {

struct NeighborCost {
    std::string method;
    double size_ratio = 1.0;
    Count particles = 0;
    int collections = 1;
    std::string spacing;    ///< automatic, geometric or linear
    double build_ns = 0.0;  ///< a particle, sorting included
    double force_ns = 0.0;  ///< a particle
    double alpha = 1.0;
    double model_ns = 0.0;  ///< what the cost model expects
};

/// Processor time, so to be run on one thread. Pairs are listed to 0.05 smallest diameters from
/// each sphere (LAMMPS's skin of 0.1), forces run over the tiles of a run in slow motion: 0.005.
NeighborCost measure_neighbor_cost(NeighborMethod method, const SizeCollections& collections,
                                   const JamState& packing);

/// Binary packings, f_S = 0.5, the methods against lambda (Monti et al., Fig. 10). A method stops
/// where a build would take more than `most_seconds`, by lambda^3 from the one before.
std::vector<NeighborCost> sweep_methods(const std::vector<NeighborMethod>& methods,
                                        const std::vector<double>& size_ratios,
                                        double most_seconds);

/// Power-law packings, `multi` with geometric, linear and the automatic collections (Fig. 11).
std::vector<NeighborCost> sweep_collections(const std::vector<double>& size_ratios,
                                            const std::vector<double>& alphas);

}  // namespace jam::bench
