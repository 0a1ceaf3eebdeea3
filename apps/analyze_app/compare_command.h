// SPDX-License-Identifier: BSD-3-Clause
// analyze_app compare: two packings or two groups side by side.
#pragma once

#include "analysis/rattlers.h"

#include <CLI/CLI.hpp>

#include <string>

namespace jam::apps {

struct CompareOptions {
    std::string a;
    std::string b;
    int rattler_threshold = default_rattler_threshold;
    bool json = false;
};

CLI::App* add_compare_command(CLI::App& program, CompareOptions& options);

/// Prints the comparison; returns the exit status.
int print_comparison(const CompareOptions& options);

}  // namespace jam::apps
