// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/stats_command.h"

#include "analysis/packing_statistics.h"
#include "analyze_app/open_packing.h"
#include "analyze_app/stage_line.h"
#include "analyze_app/statistics_text.h"
#include "shared/program.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>

namespace jam::apps {

CLI::App* add_stats_command(CLI::App& program, StatsOptions& options) {
    CLI::App* command =
        program.add_subcommand("stats", "Volume fraction, coordination, rattlers, stress");
    command->add_option("packing", options.packing, "a packing: .h5, or a LAMMPS dump")->required();
    command
        ->add_option("--rattler-threshold", options.rattler_threshold,
                     "a particle with fewer contacts is a rattler")
        ->capture_default_str();
    command->add_flag("--elastic", options.elastic,
                      "also whether it is stable, and its bulk and shear modulus (up to 20,000 "
                      "particles that bear load)");
    command->add_flag("--json", options.json, "print JSON, its keys fixed for programs");
    return command;
}

namespace {

std::string json_text(const PackingStatistics& statistics,
                      const std::optional<Elasticity>& elasticity) {
    nlohmann::ordered_json json = statistics_json(statistics);
    if (elasticity) json["elasticity"] = elasticity_json(*elasticity);
    return json.dump(4) + "\n";
}

std::string table_text(const PackingStatistics& statistics,
                       const std::optional<Elasticity>& elasticity, const std::string& name) {
    const std::string table = statistics_table(statistics, name);
    return elasticity ? table + elasticity_table(*elasticity) : table;
}

std::string stats_text(const StatsOptions& options) {
    const StageLine stage;
    stage.show("reading " + options.packing);
    const Packing packing = open_packing(options.packing);
    return naming(options.packing, [&] {
        stage.show("contacts");
        const ForceNetwork network = find_force_network(packing, options.rattler_threshold);
        stage.show("statistics");
        const PackingStatistics statistics = packing_statistics(packing, network);
        std::optional<Elasticity> elasticity;
        stage.show("stability and stiffness");
        if (options.elastic) elasticity = find_elasticity(packing, network);
        return options.json ? json_text(statistics, elasticity)
                            : table_text(statistics, elasticity, options.packing);
    });
}

}  // namespace

int print_stats(const StatsOptions& options) {
    fmt::print("{}", stats_text(options));
    return exit_good;
}

}  // namespace jam::apps
