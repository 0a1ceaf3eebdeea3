// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/stats_command.h"

#include "analysis/packing_statistics.h"
#include "analyze_app/open_packing.h"
#include "analyze_app/statistics_text.h"
#include "shared/program.h"

#include <fmt/format.h>

#include <cstdio>

namespace jam::apps {

CLI::App* add_stats_command(CLI::App& program, StatsOptions& options) {
    CLI::App* command =
        program.add_subcommand("stats", "Volume fraction, coordination, rattlers, stress");
    command->add_option("packing", options.packing, "a packing: .h5, or a LAMMPS dump")->required();
    command
        ->add_option("--rattler-threshold", options.rattler_threshold,
                     "a particle with fewer contacts is a rattler")
        ->capture_default_str();
    command->add_flag("--json", options.json, "print JSON, its keys fixed for programs");
    return command;
}

int print_stats(const StatsOptions& options) {
    const Packing packing = open_packing(options.packing);
    const ForceNetwork network = find_force_network(packing, options.rattler_threshold);
    const PackingStatistics statistics = packing_statistics(packing, network);
    const std::string text = options.json ? statistics_json(statistics).dump(4) + "\n"
                                          : statistics_table(statistics, options.packing);
    fmt::print("{}", text);
    return exit_good;
}

}  // namespace jam::apps
