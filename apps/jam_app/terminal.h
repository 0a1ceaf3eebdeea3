// SPDX-License-Identifier: BSD-3-Clause
// The terminal that standard output may be.
#pragma once

namespace jam::apps {

struct TerminalSize {
    int rows = 24;
    int columns = 80;
};

/// Whether standard output is one.
bool on_terminal();

/// Its size now; the usual one where it does not say.
TerminalSize terminal_size();

}  // namespace jam::apps
