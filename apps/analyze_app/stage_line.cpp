// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/stage_line.h"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace jam::apps {

StageLine::StageLine() : on_terminal_(::isatty(STDERR_FILENO) != 0) {}

StageLine::~StageLine() {
    show("");
}

void StageLine::show(std::string_view words) const {
    constexpr std::string_view erased_line = "\r\x1b[K";
    if (on_terminal_) fmt::print(stderr, "{}{}", erased_line, words);
}

}  // namespace jam::apps
