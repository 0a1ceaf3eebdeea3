// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/compare_command.h"

#include "analysis/compare_packings.h"
#include "analyze_app/comparison_text.h"
#include "analyze_app/open_packing.h"
#include "analyze_app/stage_line.h"
#include "shared/program.h"

#include <fmt/format.h>

#include <cstdio>

namespace jam::apps {

namespace {

/// Packings are read one after the other: only their summaries stay in memory.
std::vector<PackingSummary> summarize_all(const std::vector<std::string>& paths, int threshold) {
    const StageLine stage;
    std::vector<PackingSummary> summaries;
    for (const std::string& path : paths) {
        stage.show(fmt::format("{} of {}: {}", summaries.size() + 1, paths.size(), path));
        const Packing packing = open_packing(path);
        summaries.push_back(naming(
            path, [&] { return summarize(packing, find_force_network(packing, threshold)); }));
    }
    return summaries;
}

}  // namespace

CLI::App* add_compare_command(CLI::App& program, CompareOptions& options) {
    CLI::App* command =
        program.add_subcommand("compare", "Two packings or two groups, and what differs");
    command->add_option("a", options.a, "a packing, or a folder with packings in it")->required();
    command->add_option("b", options.b, "another")->required();
    command
        ->add_option("--rattler-threshold", options.rattler_threshold,
                     "a particle with fewer contacts is a rattler")
        ->capture_default_str();
    command->add_flag("--json", options.json, "print JSON for programs");
    return command;
}

int print_comparison(const CompareOptions& options) {
    const std::vector<std::string> paths_a = packings_at(options.a);
    const std::vector<std::string> paths_b = packings_at(options.b);
    const auto a = summarize_all(paths_a, options.rattler_threshold);
    const auto b = summarize_all(paths_b, options.rattler_threshold);
    const PackingComparison comparison = compare_packings(a, b);
    const std::string text = options.json
                                 ? comparison_json(comparison, paths_a, paths_b).dump(4) + "\n"
                                 : comparison_table(comparison, options.a, options.b);
    fmt::print("{}", text);
    return exit_good;
}

}  // namespace jam::apps
