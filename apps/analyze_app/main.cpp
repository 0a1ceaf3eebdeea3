// SPDX-License-Identifier: BSD-3-Clause
// analyze_app: measures packings. Arguments only; what is measured stands in lib/analysis.
#include "analyze_app/compare_command.h"
#include "analyze_app/convert_command.h"
#include "analyze_app/picture_command.h"
#include "analyze_app/report_command.h"
#include "analyze_app/stats_command.h"
#include "core/parallel.h"
#include "core/version.h"
#include "shared/program.h"

#include <CLI/CLI.hpp>

namespace jam::apps {

namespace {

int run(int argc, char** argv) {
    CLI::App program("Measures packings of spheres: ours (.h5) and LAMMPS dumps.", "analyze_app");
    program.set_version_flag("--version", std::string("analyze_app ") + version);
    program.require_subcommand(1);
    program.fallthrough();
    int threads = 0;
    program.add_option("--threads", threads, "threads to use; 0: as many as the machine has")
        ->check(CLI::Range(0, 1024));
    StatsOptions stats;
    const CLI::App* stats_command = add_stats_command(program, stats);
    CompareOptions compare;
    const CLI::App* compare_command = add_compare_command(program, compare);
    ConvertOptions convert;
    const CLI::App* convert_command = add_convert_command(program, convert);
    PictureOptions picture;
    const CLI::App* picture_command = add_picture_command(program, picture);
    ReportOptions report;
    const CLI::App* report_command = add_report_command(program, report);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? exit_good : exit_bad_input;
    }
    return run_with_threads(threads, [&]() -> int {
        if (stats_command->parsed()) return print_stats(stats);
        if (compare_command->parsed()) return print_comparison(compare);
        if (convert_command->parsed()) return convert_packing(convert);
        if (picture_command->parsed()) return write_picture(picture);
        if (report_command->parsed()) return write_report(report);
        return exit_good;
    });
}

}  // namespace

}  // namespace jam::apps

int main(int argc, char** argv) {
    return jam::apps::run_guarded("analyze_app", [&] { return jam::apps::run(argc, argv); });
}
