// SPDX-License-Identifier: BSD-3-Clause
// Runs of a sweep as processes of their own, so that none can take another with it.
#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace jam::apps {

struct ChildRun {
    pid_t process = -1;
    std::size_t run = 0;  ///< its place in the sweep
    int threads = 1;
    double memory = 0.0;  ///< bytes
};

struct EndedRun {
    std::size_t run = 0;
    int status = 0;  ///< exit status, or minus the signal that ended it
};

class ChildRuns {
  public:
    const std::vector<ChildRun>& running() const { return running_; }

    /// Starts this program with the arguments; what it says is added to the end of the file
    /// `output`. The process is sent SIGTERM should we end before it. Throws FileError.
    void start(ChildRun child, const std::vector<std::string>& arguments,
               const std::filesystem::path& output);

    /// Those that have ended since the last call.
    std::vector<EndedRun> take_ended();

    /// SIGTERM to all, at which a run saves its state and ends.
    void stop() const;

  private:
    std::vector<ChildRun> running_;
};

}  // namespace jam::apps
