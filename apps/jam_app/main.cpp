// SPDX-License-Identifier: BSD-3-Clause
// jam_app: from a scene to a jammed packing.
#include "core/version.h"
#include "jam_app/commands.h"
#include "jamming/scene_keys.h"
#include "shared/program.h"
#include "shared/shell_word.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>
#include <string>

namespace jam::apps {

static void add_overrides(CLI::App& command, std::vector<std::string>& overrides,
                          const char* what) {
    command.add_option("--set", overrides, what)->allow_extra_args(false);
}

static void add_scene_options(CLI::App& command, SceneOptions& options,
                              const char* what = "Scene file (TOML)") {
    command.add_option("scene", options.scene, what)->required();
    add_overrides(command, options.overrides,
                  "table.key=value in place of what the scene says; may be given again");
}

static std::string joined(int argc, char** argv) {
    std::string out = "jam_app";
    for (int i = 1; i < argc; ++i) out += fmt::format(" {}", shell_word(argv[i]));
    return out;
}

/// Options that are short for a --set are turned into one, so that the same rules hold for them.
static void add_threads(CLI::App& command, std::vector<std::string>& overrides) {
    command.add_option_function<std::string>(
        "--threads",
        [&overrides](const std::string& count) { overrides.push_back("run.threads=" + count); },
        "Threads; 0: all that the machine has (run.threads)");
}

static void add_run_options(CLI::App& command, RunOptions& options) {
    add_scene_options(command, options.scene);
    command.add_option_function<std::string>(
        "--out",
        [&options](const std::string& folder) {
            options.scene.overrides.push_back("run.output=" + toml_text(folder));
        },
        "Folder of the results (run.output)");
    add_threads(command, options.scene.overrides);
    command.add_flag("--resume", options.resume, "Go on with the run in the folder");
}

static void add_rejam_options(CLI::App& command, RejamOptions& options) {
    command.add_option("packing", options.packing, "Packing: .h5, or a LAMMPS dump or data file")
        ->required();
    command.add_option("-o,--out", options.folder, "Folder of the results")->required();
    command.add_flag("--without-rattlers", options.without_rattlers,
                     "Take the rattlers out before");
    add_overrides(command, options.overrides,
                  "table.key=value in place of what the packing's scene says; may be given again");
    add_threads(command, options.overrides);
}

static void add_sweep_options(CLI::App& command, SweepOptions& options) {
    command.add_option("sweep", options.file, "Sweep file (TOML)")->required();
    command.add_flag("--list", options.list, "Print one command for each run, and run nothing");
    command.add_option("--only", options.only, "Do this run alone, unless it is done");
    command.add_option("--threads", options.threads, "Threads of that run; 0: all of the machine")
        ->check(CLI::Range(0, 4096))
        ->needs("--only");
}

static int run_program(int argc, char** argv) {
    CLI::App program("Jams packings of spheres over a wide range of sizes.", "jam_app");
    program.set_version_flag("--version", std::string("jam_app ") + version);
    program.require_subcommand(1);
    std::function<int()> chosen;

    std::string kind = "power-law";
    auto* make = program.add_subcommand("new", "Print a commented scene to start from");
    make->add_option("kind", kind, "Kind of sizes: power-law, binary, monodisperse, ...");
    make->callback([&] { chosen = [&] { return new_scene(kind); }; });

    auto* keys = program.add_subcommand("keys", "List the keys of a scene: unit, default, rule");
    keys->callback([&] { chosen = list_keys; });

    SceneOptions checked;
    auto* check = program.add_subcommand("check", "Say what a scene will do, without running it");
    add_scene_options(*check, checked);
    check->callback([&] { chosen = [&] { return check_scene(checked); }; });

    RunOptions run;
    run.command_line = joined(argc, argv);
    auto* run_command = program.add_subcommand("run", "Jam a scene, into a folder of its own");
    add_run_options(*run_command, run);
    run_command->callback([&] { chosen = [&] { return run_scene(run); }; });

    RejamOptions rejam;
    rejam.command_line = run.command_line;
    auto* rejam_command = program.add_subcommand(
        "rejam", "Let a packing converge again, with or without its rattlers");
    add_rejam_options(*rejam_command, rejam);
    rejam_command->callback([&] { chosen = [&] { return rejam_packing(rejam); }; });

    SweepOptions sweep;
    sweep.command_line = run.command_line;
    auto* sweep_command = program.add_subcommand(
        "sweep", "Jam a grid of scenes, as many at once as the machine bears");
    add_sweep_options(*sweep_command, sweep);
    sweep_command->callback([&] { chosen = [&] { return sweep_scenes(sweep); }; });

    TradeOptions trade;
    trade.command_line = run.command_line;
    auto* trade_command = program.add_subcommand(
        "trade", "Run a scene over the choices that trade speed for accuracy, and compare");
    add_scene_options(*trade_command, trade.scene);
    trade_command->add_option("-o,--out", trade.folder, "Folder of the results")->required();
    trade_command->add_option("--seeds", trade.seeds, "Seeds for each choice, from run.seed on")
        ->check(CLI::Range(1, 1000));
    add_threads(*trade_command, trade.scene.overrides);
    trade_command->callback([&] { chosen = [&] { return trade_scene(trade); }; });

    HandoffOptions handoff;
    auto* handoff_command =
        program.add_subcommand("handoff", "Write what LAMMPS needs to jam a scene or a packing");
    add_scene_options(*handoff_command, handoff.scene, "Scene file (TOML), or a packing");
    handoff_command->add_option("-o,--out", handoff.folder, "Folder for the files")->required();
    handoff_command->callback([&] { chosen = [&] { return hand_off(handoff); }; });

    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? exit_good : exit_bad_input;
    }
    return chosen();
}

}  // namespace jam::apps

int main(int argc, char** argv) {
    return jam::apps::run_guarded("jam_app", [&] { return jam::apps::run_program(argc, argv); });
}
