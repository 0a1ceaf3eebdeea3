// SPDX-License-Identifier: BSD-3-Clause
// Arguments as a shell takes them, for commands that are shown to be typed.
#pragma once

#include <string>

namespace jam::apps {

/// `text` as one word of a POSIX shell; quoted only where it has to be.
std::string shell_word(const std::string& text);

}  // namespace jam::apps
