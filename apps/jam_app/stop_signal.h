// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C and SIGTERM as a question that the run asks after every step.
#pragma once

#include <string>

namespace jam::apps {

/// While this lives, the first SIGINT or SIGTERM is only noted; a second one ends the program as it
/// would without us. At most one object at a time.
class StopSignal {
  public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    bool came() const;
    std::string name() const;  ///< of the signal that came
};

}  // namespace jam::apps
