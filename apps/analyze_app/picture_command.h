// SPDX-License-Identifier: BSD-3-Clause
// analyze_app picture: a packing as one would see it.
#pragma once

#include "analysis/rattlers.h"
#include "report/picture.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace jam::apps {

struct PictureOptions {
    std::string packing;
    std::string output;
    std::string color = "diameter";
    int rattler_threshold = default_rattler_threshold;
    bool without_rattlers = false;
    std::vector<std::string> slices;
    std::string size = "1600x1200";
    std::string view = "corner";
    int samples = PictureSettings{}.samples;
    bool cut = false;
    bool without_cell = false;
    bool without_legend = false;
};

CLI::App* add_picture_command(CLI::App& program, PictureOptions& options);

/// Writes the picture; returns the exit status.
int write_picture(const PictureOptions& options);

}  // namespace jam::apps
