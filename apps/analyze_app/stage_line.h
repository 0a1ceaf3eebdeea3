// SPDX-License-Identifier: BSD-3-Clause
// What a command is at, on one line of a terminal that is gone when it has ended.
#pragma once

#include <string_view>

namespace jam::apps {

/// Shows nothing where standard error is no terminal.
class StageLine {
  public:
    StageLine();
    ~StageLine();
    StageLine(const StageLine&) = delete;
    StageLine& operator=(const StageLine&) = delete;

    /// Takes the place of what was shown before.
    void show(std::string_view words) const;

  private:
    bool on_terminal_;
};

}  // namespace jam::apps
