// SPDX-License-Identifier: BSD-3-Clause
// A sweep: one scene with some of its keys over lists of values, every combination a run of its
// own. docs/sweeps.md describes the file.
#pragma once

#include "core/types.h"
#include "jamming/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace jam {

struct SweepRun {
    std::string name;  ///< such as "size_ratio=5_seed=1": the name of its folder, too
    Scene scene;       ///< run.output is its folder
};

struct Sweep {
    std::vector<SweepRun> runs;    ///< in the order of the file, the last key of the grid fastest
    std::filesystem::path output;  ///< the folder of their folders
    int threads = 0;               ///< of all runs together; 0: all that the machine has
    int threads_a_run = 0;         ///< 0: as many as there are for each
    double memory = 0.0;           ///< of all runs together, GB; 0: what the machine has available
};

/// Reads a sweep. Every run's scene is checked. Throws one InputError that lists every mistake
/// once, with its place in the file.
Sweep read_sweep(const std::filesystem::path& file);

/// About what a run takes at its peak, bytes.
double memory_of_run(const Scene& scene);

}  // namespace jam
