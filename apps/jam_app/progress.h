// SPDX-License-Identifier: BSD-3-Clause
// How a run shows itself: a live line on a terminal, plain lines in the log and elsewhere.
#pragma once

#include "jamming/record.h"
#include "jamming/scene.h"
#include "jamming/verdict.h"

#include <spdlog/logger.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

namespace jam::apps {

class Progress {
  public:
    /// Appends to the log at `log_file`; plain lines also go to standard output unless that is a
    /// terminal, which gets the live line.
    Progress(const Scene& scene, const std::filesystem::path& log_file);
    ~Progress();

    /// Shows a record; plain lines come no more often than every half minute.
    void show(const Record& record, const Verdict& verdict);

    /// A message of one or more lines, on the terminal and in the log.
    void say(const std::string& text);

    /// A line in the log alone.
    void note(const std::string& text);

  private:
    using Clock = std::chrono::steady_clock;

    void clear_live_line();

    double applied_pressure_;
    StopSettings stop_;
    Clock::time_point began_ = Clock::now();
    Clock::time_point next_line_ = began_;
    bool on_terminal_;
    bool live_line_shown_ = false;
    std::shared_ptr<spdlog::logger> log_;
};

}  // namespace jam::apps
