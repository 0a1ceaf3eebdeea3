// SPDX-License-Identifier: BSD-3-Clause
// One run of many, a sweep's or a trade's, in the folder that is its own.
#pragma once

#include "sweep/run_state.h"

#include <optional>
#include <string>

namespace jam::apps {

/// Begins the run, or goes on with it where `state` says that it has begun, and leaves the mark in
/// its folder once it has converged. Returns the exit status as run_scene does.
int do_swept_run(const SweepRun& run, RunState state, const std::string& command_line,
                 std::optional<int> threads = std::nullopt);

}  // namespace jam::apps
