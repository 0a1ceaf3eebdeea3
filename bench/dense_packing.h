// SPDX-License-Identifier: BSD-3-Clause
// Truly dense packings to measure on, of any size: compressed by the nph protocol, kept in a folder
// between runs, and replicated.
#pragma once

#include "jamming/jam_state.h"

namespace jam::bench {

struct DensePacking {
    double size_ratio = 1.0;
    double alpha = 1.0;           ///< of a power law
    Count count = 100000;         ///< a binary one: about
    double small_fraction = 0.0;  ///< above 0: a binary packing with this f_S
    int replicas = 1;             ///< copies along each edge
};

/// A power-law, binary or (size ratio 1) monodisperse packing compressed at p = 1e-3, masses by
/// diameter, until its volume fraction has stopped rising by more than 0.1 % in 500 steps: near
/// jamming, most contacts closed. Made once and kept as build/bench_packings/*.h5 below the current
/// folder. Then replicated, which keeps every contact.
JamState dense_packing(const DensePacking& wanted);

/// Large spheres of diameter `size_ratio`, `large_along` a row in a cubic lattice, in a jammed
/// monodisperse packing that is replicated and cut away around them; the cell is such that f_S is
/// 0.5. Nothing grows but the number of particles, so that a size ratio of 300 takes seconds. The
/// bulk is a jammed one; a large sphere's surface has fewer contacts than a relaxed one.
JamState dense_matrix(double size_ratio, int large_along);

/// The same scene for all benchmarks of steps: p = 1e-3, gamma = 0.5.
Scene bench_scene(const DensePacking& wanted);

}  // namespace jam::bench
