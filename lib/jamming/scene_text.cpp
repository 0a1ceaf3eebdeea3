// SPDX-License-Identifier: BSD-3-Clause
// From a scene to text: as TOML, as a commented template, and the reference of all keys.
#include "core/check.h"
#include "jamming/scene_file.h"
#include "jamming/scene_keys.h"

#include <algorithm>

namespace jam {

static SceneDraft draft_of(const Scene& scene) {
    SceneDraft draft;
    draft.scene = scene;
    if (scene.start.packing.empty()) draft.sizes = draft_of(scene.sizes);
    return draft;
}

static std::string table_of(const SceneKey& key) {
    return key.name.substr(0, key.name.find('.'));
}

static std::string name_in_table(const SceneKey& key) {
    return key.name.substr(key.name.find('.') + 1);
}

/// Whether the scene that is being written says anything by this key.
static bool is_written(const SceneKey& key, const SceneDraft& draft) {
    const bool from_packing = !draft.scene.start.packing.empty();
    if (table_of(key) == "sizes")
        return !from_packing && find_sizes_kind(draft.sizes.kind)->takes(key.name);
    return !(from_packing && key.name == "start.volume_fraction");
}

/// The value as TOML; empty if there is none.
static std::string value_text(const SceneKey& key, const SceneDraft& draft) {
    const std::optional<SceneValue> value = key.field.get(draft);
    return value && is_written(key, draft) ? toml_text(*value) : "";
}

/// A line for each key; `line` turns key and value into text, an empty text leaves it out.
template <typename Line>
static std::string tables(const SceneDraft& draft, Line&& line) {
    std::string out;
    std::string table;
    for (const SceneKey& key : scene_keys()) {
        const std::string text = line(key, value_text(key, draft));
        if (text.empty()) continue;
        if (table_of(key) != table) {
            table = table_of(key);
            out += fmt::format("{}[{}]\n", out.empty() ? "" : "\n", table);
        }
        out += text;
    }
    return out;
}

std::string scene_text(const Scene& scene) {
    return tables(draft_of(scene), [](const SceneKey& key, const std::string& value) {
        return value.empty() ? "" : fmt::format("{} = {}\n", name_in_table(key), value);
    });
}

std::vector<std::string> scene_differences(const Scene& scene, const Scene& was) {
    std::vector<std::string> out;
    const SceneDraft now = draft_of(scene);
    const SceneDraft then = draft_of(was);
    for (const SceneKey& key : scene_keys()) {
        const std::string a = value_text(key, now);
        const std::string b = value_text(key, then);
        if (a != b)
            out.push_back(fmt::format("{} = {} (was {})", key.name, a.empty() ? "nothing" : a,
                                      b.empty() ? "nothing" : b));
    }
    return out;
}

std::vector<std::string> differences_of_runs(const Scene& scene, const Scene& was) {
    std::vector<std::string> out = scene_differences(scene, was);
    std::erase_if(out, [](const std::string& difference) {
        return difference.starts_with("stop.") ||
               (difference.starts_with("run.") && !difference.starts_with("run.seed "));
    });
    return out;
}

// --- templates ----------------------------------------------------------------------------------

/// What a line says after its value. Ranges are left to the documentation and the error messages.
static std::string comment(const SceneKey& key) {
    std::string out = key.meaning;
    if (!key.unit.empty()) out += fmt::format(" [{}]", key.unit);
    if (key.field.rule.starts_with("one of")) out += fmt::format(": {}", key.field.rule);
    return out;
}

static std::string template_line(const SceneKey& key, const std::string& value) {
    const std::string line =
        value.empty() || key.by_accuracy
            ? fmt::format("# {} = {}", name_in_table(key), toml_text(key.example))
            : fmt::format("{} = {}", name_in_table(key), value);
    return fmt::format("{:<32}# {}\n", line, comment(key));
}

/// A draft in which every required key of the kind holds its example.
static SceneDraft example_draft(const SizesKind& kind) {
    SceneDraft draft;
    draft.sizes.kind = kind.name;
    for (const std::string& name : kind.required) {
        const SceneKey& key = *find_scene_key(name);
        key.field.set(draft, key.example);
    }
    return draft;
}

std::string scene_template(std::string_view sizes_kind) {
    const SizesKind* kind = find_sizes_kind(sizes_kind);
    require(kind != nullptr, "kind '{}': must be {}; write for example 'jam_app new power-law'",
            sizes_kind, find_scene_key("sizes.kind")->field.rule);
    const SceneDraft draft = example_draft(*kind);
    const auto line = [&](const SceneKey& key, const std::string& value) -> std::string {
        return is_written(key, draft) ? template_line(key, value) : "";
    };
    return fmt::format(
               "# A scene of jam_app: {}, {}.\n"
               "# 'jam_app keys' has the rule of every key, 'jam_app check' tells what will come "
               "of "
               "them.\n\n",
               kind->name, kind->meaning) +
           tables(draft, line);
}

// --- reference ----------------------------------------------------------------------------------

static std::string default_of(const SceneKey& key) {
    if (!key.no_value.empty()) return key.no_value;
    return fmt::format("`{}`{}", toml_text(key.example), key.by_accuracy ? "; by accuracy" : "");
}

static std::string in_code(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names)
        out += fmt::format("{}`{}`", out.empty() ? "" : ", ", name.substr(name.find('.') + 1));
    return out;
}

static std::string kinds_reference() {
    std::string out = "\n| sizes.kind | distribution | needs | takes also |\n|---|---|---|---|\n";
    for (const SizesKind& kind : sizes_kinds())
        out += fmt::format("| `{}` | {} | {} | {} |\n", kind.name, kind.meaning,
                           in_code(kind.required), in_code(kind.optional));
    return out;
}

std::string scene_reference() {
    std::string out;
    std::string table;
    for (const SceneKey& key : scene_keys()) {
        if (table_of(key) != table) {
            if (table == "sizes") out += kinds_reference();
            table = table_of(key);
            out += fmt::format(
                "{}### [{}]\n\n| key | meaning | unit | default | rule |\n"
                "|---|---|---|---|---|\n",
                out.empty() ? "" : "\n", table);
        }
        out += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, key.meaning, key.unit,
                           default_of(key), key.field.rule);
    }
    return out;
}

}  // namespace jam
