// SPDX-License-Identifier: BSD-3-Clause
// How a sweep shows itself: a live table on a terminal, a line for each event elsewhere.
#pragma once

#include "sweep/sweep_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace jam::apps {

enum class RunStatus : std::uint8_t { left, running, converged, stopped, failed };

class SweepTable {
  public:
    explicit SweepTable(const Sweep& sweep);

    /// Draws the table anew; nothing unless on a terminal.
    void show(const std::vector<RunStatus>& statuses);

    /// A line that stays.
    void say(std::string_view text);

    /// The last words: how many of each, and what failed.
    void close(const std::vector<RunStatus>& statuses);

  private:
    void clear();

    const Sweep& sweep_;
    bool on_terminal_;
    int lines_shown_ = 0;
};

/// Where what a run says goes.
std::filesystem::path output_file(const SweepRun& run);

}  // namespace jam::apps
