// SPDX-License-Identifier: BSD-3-Clause
// analyze_app report: everything about one packing, or about many, as a page to look at.
#pragma once

#include "report/report.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace jam::apps {

struct ReportOptions {
    std::vector<std::string> packings;  ///< files, and folders to look for packings in
    std::string output = "report";
    ReportSettings settings;
};

CLI::App* add_report_command(CLI::App& program, ReportOptions& options);

/// Writes the report; returns the exit status.
int write_report(const ReportOptions& options);

}  // namespace jam::apps
