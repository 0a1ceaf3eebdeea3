// SPDX-License-Identifier: BSD-3-Clause
// jam_app: from a scene to a jammed packing.
#include "core/version.h"
#include "jam_app/commands.h"
#include "shared/program.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace jam::apps {

static void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option("scene", options.scene, "Scene file (TOML)")->required();
    command
        .add_option("--set", options.overrides,
                    "table.key=value in place of what the scene says; may be given again")
        ->allow_extra_args(false);
}

static int run_program(int argc, char** argv) {
    CLI::App program("Jams packings of spheres over a wide range of sizes.", "jam_app");
    program.set_version_flag("--version", version);
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
