// SPDX-License-Identifier: BSD-3-Clause
// Scenes as text: TOML in, TOML out. docs/scene.md lists the keys.
#pragma once

#include "jamming/scene.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jam {

/// Reads a scene file, then the overrides "table.key=value" (a word may go without its quotes).
/// Throws one InputError that lists every mistake on a line of its own, as
/// "file:line:column: key = value: rule; remedy", overrides as "--set: key = value: ...".
/// Paths of input files are relative to the scene file, in an override to the current folder.
Scene read_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same from memory; `file` gives the name in messages and the folder of relative paths.
Scene parse_scene(std::string_view text, const std::filesystem::path& file,
                  std::span<const std::string> overrides = {});

/// The scene as TOML with all its keys: parse_scene gives the same scene back, bit for bit, from
/// the folder that the paths in it are relative to.
std::string scene_text(const Scene& scene);

/// A commented scene of one kind of sizes ("power-law", ...) to start from. Throws InputError for
/// another kind.
std::string scene_template(std::string_view sizes_kind);

/// All keys with unit, default and rule, as the Markdown tables of docs/scene.md.
std::string scene_reference();

/// Keys in which two scenes differ, each as "key = value (was value)".
std::vector<std::string> scene_differences(const Scene& scene, const Scene& was);

/// Those of them that make it another run: all but [stop] and [run], and run.seed.
std::vector<std::string> differences_of_runs(const Scene& scene, const Scene& was);

}  // namespace jam
