// SPDX-License-Identifier: BSD-3-Clause
// Truly dense packings to measure on: compressed by the nph protocol, and kept in a folder between
// runs.
#pragma once

#include "jamming/jam_state.h"

namespace jam::bench {

struct DensePacking {
    double size_ratio = 1.0;
    double alpha = 1.0;
    Count count = 100000;
};

/// A power-law packing (monodisperse at size ratio 1) compressed at p = 1e-3, masses by diameter,
/// until its volume fraction has stopped rising by more than 0.1 % in 500 steps: near jamming, most
/// contacts closed. Made once and kept as build/bench_packings/*.h5 below the current folder.
JamState dense_packing(const DensePacking& wanted);

/// The same scene for all benchmarks of steps: p = 1e-3, gamma = 0.5.
Scene bench_scene(const DensePacking& wanted);

}  // namespace jam::bench
