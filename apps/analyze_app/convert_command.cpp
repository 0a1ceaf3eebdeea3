// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/convert_command.h"

#include "analysis/measured_file.h"
#include "analyze_app/open_packing.h"
#include "core/check.h"
#include "packing/packing_io.h"
#include "shared/program.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace jam::apps {

CLI::App* add_convert_command(CLI::App& program, ConvertOptions& options) {
    CLI::App* command = program.add_subcommand(
        "convert", "Between .h5 (ours), .dump and .data (LAMMPS), .xyz (extended XYZ) and .csv");
    command->add_option("from", options.from, "a packing")->required();
    command->add_option("to", options.to, "the file to write; its ending names the format")
        ->required();
    return command;
}

/// Our own format holds contacts and observables, too; whatever the packing comes from has none. A
/// packing that cannot be measured, its cell being too small, is converted all the same.
static void write_measured(const Packing& packing, const std::filesystem::path& path) {
    try {
        const ForceNetwork network = find_force_network(packing);
        save_measured(packing, network, packing_statistics(packing, network), path);
    } catch (const InputError&) {
        write_packing(packing, path);
    }
}

int convert_packing(const ConvertOptions& options) {
    const Packing packing = open_packing(options.from);
    const std::string lost = what_is_lost(packing, options.to);
    if (std::filesystem::path(options.to).extension() == ".h5")
        write_measured(packing, options.to);
    else
        write_packing(packing, options.to);
    if (!lost.empty()) fmt::print(stderr, "{}\n", lost);
    return exit_good;
}

}  // namespace jam::apps
