// SPDX-License-Identifier: BSD-3-Clause
// Running another program and waiting for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jam {

struct ChildRun {
    bool found = true;  ///< false: there is no such program
    int status = -1;    ///< its exit status; -1 if a signal ended it
    std::string words;  ///< what it wrote to its outputs
};

/// Runs `command` (found through PATH) in `folder` without any input. Throws FileError if the
/// machine does not let another program start.
ChildRun run_child(const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace jam
