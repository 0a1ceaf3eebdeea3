// SPDX-License-Identifier: BSD-3-Clause
// analyze_app convert: a packing from one format to another.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace jam::apps {

struct ConvertOptions {
    std::string from;
    std::string to;
};

CLI::App* add_convert_command(CLI::App& program, ConvertOptions& options);

/// Writes the packing anew and says on standard error what the format could not hold; returns the
/// exit status.
int convert_packing(const ConvertOptions& options);

}  // namespace jam::apps
