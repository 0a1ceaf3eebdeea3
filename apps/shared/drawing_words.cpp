// SPDX-License-Identifier: BSD-3-Clause
#include "shared/drawing_words.h"

#include <fmt/format.h>

#include <cstdio>

namespace jam::apps {

void tell_of_drawing(const Drawing& drawing) {
    if (!drawing.gnuplot_found)
        fmt::print(stderr,
                   "gnuplot is not installed, so that no figure is drawn; their tables and "
                   "scripts are written. Install it (Debian: gnuplot-nox), then run this "
                   "again.\n");
    for (const std::string& problem : drawing.problems)
        fmt::print(stderr, "gnuplot: {}\n", problem);
}

}  // namespace jam::apps
