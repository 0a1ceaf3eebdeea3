// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

namespace jam::apps {

bool on_terminal() {
    return isatty(STDOUT_FILENO) == 1;
}

TerminalSize terminal_size() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {};
    return {size.ws_row, size.ws_col};
}

}  // namespace jam::apps
