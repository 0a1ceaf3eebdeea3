// SPDX-License-Identifier: BSD-3-Clause
// What stands in a scene file and its overrides, key by key, before anything is made of it.
#pragma once

#include "jamming/scene.h"
#include "jamming/scene_rules.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jam {

struct SceneEntry {
    std::string name;  ///< "table.key"
    SceneValue value;
    std::string text;              ///< the value as TOML, shortened
    std::string where;             ///< "file:line:column" of the value, or "--set"
    std::filesystem::path folder;  ///< that relative paths in the value are meant from
};

struct SceneEntries {
    std::vector<SceneEntry> entries;            ///< each name once
    std::map<std::string, std::string> tables;  ///< name -> where it begins
    std::string file;

    const SceneEntry* find(std::string_view name) const;
};

/// Throws InputError with file, line and column if the text is not TOML, or if an override is not
/// "table.key=value". An override replaces the entry of the file.
SceneEntries read_entries(std::string_view text, const std::filesystem::path& file,
                          std::span<const std::string> overrides);

/// The scene that the entries say. Throws one InputError that lists every mistake at its place.
Scene scene_from(SceneEntries entries);

}  // namespace jam
