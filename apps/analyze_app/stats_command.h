// SPDX-License-Identifier: BSD-3-Clause
// analyze_app stats: the numbers that one packing is known by.
#pragma once

#include "analysis/rattlers.h"

#include <CLI/CLI.hpp>

#include <string>

namespace jam::apps {

struct StatsOptions {
    std::string packing;
    int rattler_threshold = default_rattler_threshold;
    bool elastic = false;
    bool json = false;
};

CLI::App* add_stats_command(CLI::App& program, StatsOptions& options);

/// Prints the statistics; returns the exit status.
int print_stats(const StatsOptions& options);

}  // namespace jam::apps
