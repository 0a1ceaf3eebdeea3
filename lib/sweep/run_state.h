// SPDX-License-Identifier: BSD-3-Clause
// How far a run of a sweep is, read off its folder.
#pragma once

#include "sweep/sweep_file.h"

namespace jam {

enum class RunState : std::uint8_t {
    left,       ///< not begun
    begun,      ///< has a checkpoint to go on from
    converged,  ///< by the criteria that the sweep names now
};

/// Throws InputError if the folder holds a run of another scene.
RunState state_of(const SweepRun& run);

/// Makes the run's folder with its scene.toml. Throws FileError.
void prepare_folder(const SweepRun& run);

/// Leaves the mark, a file `converged`, by which state_of knows it. Throws FileError.
void mark_converged(const SweepRun& run);

}  // namespace jam
