// SPDX-License-Identifier: BSD-3-Clause
// A run's state on disk: whole or absent, with the one before it kept beside it.
#pragma once

#include "jamming/jam_state.h"

#include <filesystem>
#include <string>

namespace jam {

struct Checkpoint {
    JamState state;
    std::string scene;  ///< text of the scene that the run was started with
};

/// Writes `path`, whole or not at all; the checkpoint that stood there stays as `path` +
/// ".previous". Throws FileError if the disk fails.
void save_checkpoint(const JamState& state, const std::string& scene,
                     const std::filesystem::path& path);

/// Reads back the same bits; takes the previous checkpoint where the last one is damaged. Throws
/// FileError if neither can be read.
Checkpoint load_checkpoint(const std::filesystem::path& path);

}  // namespace jam
