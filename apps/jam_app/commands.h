// SPDX-License-Identifier: BSD-3-Clause
// The commands of jam_app. Each returns the exit status; bad input is thrown as InputError.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace jam::apps {

/// What a user may say about a scene on the command line.
struct SceneOptions {
    std::filesystem::path scene;
    std::vector<std::string> overrides;  ///< "table.key=value"
};

struct RunOptions {
    SceneOptions scene;  ///< --out and --threads among the overrides
    bool resume = false;
    std::string command_line;
};

struct HandoffOptions {
    SceneOptions scene;  ///< or a packing
    std::filesystem::path folder;
};

struct RejamOptions {
    std::filesystem::path packing;
    std::filesystem::path folder;
    bool without_rattlers = false;
    std::vector<std::string> overrides;  ///< "table.key=value"
    std::string command_line;
};

struct SweepOptions {
    std::filesystem::path file;
    bool list = false;           ///< print a command for each run
    std::string only;            ///< name of the one run to do; empty: all
    std::optional<int> threads;  ///< of that run
    std::string command_line;
};

struct TradeOptions {
    SceneOptions scene;
    std::filesystem::path folder;
    int seeds = 1;
    std::string command_line;
};

/// Prints a commented scene.
int new_scene(const std::string& sizes_kind);

/// Prints all keys of a scene as Markdown.
int list_keys();

/// Says what a scene will do.
int check_scene(const SceneOptions& options);

/// Runs a scene to its verdict, into a folder of its own.
int run_scene(const RunOptions& options);

/// Lets a packing converge again, and says what has changed.
int rejam_packing(const RejamOptions& options);

/// Writes what LAMMPS needs to do the scene's protocol.
int hand_off(const HandoffOptions& options);

/// Runs a scene over the choices that trade speed for accuracy, and says what each costs.
int trade_scene(const TradeOptions& options);

/// Does the runs of a sweep that are not yet done.
int sweep_scenes(const SweepOptions& options);

}  // namespace jam::apps
