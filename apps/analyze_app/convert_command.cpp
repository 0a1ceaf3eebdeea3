// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/convert_command.h"

#include "analyze_app/open_packing.h"
#include "packing/packing_io.h"
#include "shared/program.h"

#include <fmt/format.h>

#include <cstdio>

namespace jam::apps {

CLI::App* add_convert_command(CLI::App& program, ConvertOptions& options) {
    CLI::App* command = program.add_subcommand(
        "convert", "Between .h5 (ours), .dump and .data (LAMMPS), .xyz (extended XYZ) and .csv");
    command->add_option("from", options.from, "a packing")->required();
    command->add_option("to", options.to, "the file to write; its ending names the format")
        ->required();
    return command;
}

int convert_packing(const ConvertOptions& options) {
    const Packing packing = open_packing(options.from);
    const std::string lost = what_is_lost(packing, options.to);
    write_packing(packing, options.to);
    if (!lost.empty()) fmt::print(stderr, "{}\n", lost);
    return exit_good;
}

}  // namespace jam::apps
