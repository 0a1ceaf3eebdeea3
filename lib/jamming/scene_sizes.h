// SPDX-License-Identifier: BSD-3-Clause
// Table [sizes] of a scene: which keys belong to which kind, and what becomes of them.
#pragma once

#include "jamming/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jam {

/// Table [sizes] as it is written: all keys of all kinds, most of them not given.
struct SizesDraft {
    std::string kind;
    std::optional<double> alpha;
    std::optional<double> beta;
    std::optional<double> size_ratio;
    std::optional<double> small_fraction;
    std::optional<Count> large_count;
    std::optional<double> eta;
    std::optional<double> sigma;
    std::filesystem::path file;
    std::optional<Weight> weight;
    std::optional<Count> count;
    DrawMethod draw = DrawMethod::stratified;
};

/// Needs every key that the kind requires. Throws InputError or FileError if a table cannot be
/// used.
SizesSettings settings_of(const SizesDraft& draft);

/// The reverse.
SizesDraft draft_of(const SizesSettings& settings);

/// The keys of table [sizes] that belong to one kind (besides sizes.kind).
struct SizesKind {
    std::string name;
    std::string meaning;
    std::vector<std::string> required;
    std::vector<std::string> optional;

    bool takes(std::string_view key) const;
};
std::span<const SizesKind> sizes_kinds();
const SizesKind* find_sizes_kind(std::string_view name);

}  // namespace jam
