// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene_entries.h"

#include "core/check.h"
#include "jamming/scene_keys.h"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

namespace jam {

const SceneEntry* SceneEntries::find(std::string_view name) const {
    const auto at = std::ranges::find(entries, name, &SceneEntry::name);
    return at == entries.end() ? nullptr : &*at;
}

static std::string position(const std::string& file, const toml::source_region& source) {
    return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

static SceneValue numbers_of(const toml::array& array) {
    std::vector<double> numbers;
    for (const toml::node& node : array) {
        const auto number = node.value<double>();
        if (!node.is_number() || !number) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

static SceneValue value_of(const toml::node& node) {
    if (const auto* truth = node.as_boolean()) return truth->get();
    if (const auto* whole = node.as_integer()) return Count{whole->get()};
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* array = node.as_array()) return numbers_of(*array);
    return {};
}

static std::string text_of(const toml::node& node) {
    const SceneValue value = value_of(node);
    if (value.index() != 0) return toml_text(value);
    if (node.is_table()) return "{ a table }";
    std::ostringstream out;
    node.visit([&](const auto& other) { out << other; });
    return out.str();
}

/// On one line and not longer than a message can bear.
static std::string shown(const toml::node& node) {
    std::string text = text_of(node);
    std::ranges::replace(text, '\n', ' ');
    constexpr std::size_t longest = 60;
    if (text.size() > longest) text = text.substr(0, longest - 3) + "...";
    return text;
}

static SceneEntry entry_of(const std::string& name, const toml::node& node,
                           const SceneEntries& out) {
    return {name, value_of(node), shown(node), position(out.file, node.source()),
            std::filesystem::path(out.file).parent_path()};
}

static bool is_scene_table(std::string_view name) {
    return std::ranges::any_of(scene_keys(), [&](const SceneKey& key) {
        return key.name.substr(0, key.name.find('.')) == name;
    });
}

/// Adds what stands in `table`, in the order of the file (toml++ sorts by name).
static void add_table(const toml::table& table, const std::string& prefix, SceneEntries& out) {
    std::vector<std::pair<const toml::key*, const toml::node*>> items;
    for (const auto& [key, node] : table) items.emplace_back(&key, &node);
    std::ranges::sort(items, {}, [](const auto& item) {
        const toml::source_position at = item.first->source().begin;
        return std::pair(at.line, at.column);
    });
    for (const auto& [key, node] : items) {
        const std::string name = prefix + std::string(key->str());
        const auto* inner = prefix.empty() ? node->as_table() : nullptr;
        if (inner && is_scene_table(name)) out.tables[name] = position(out.file, node->source());
        if (inner && (is_scene_table(name) || !inner->empty()))
            add_table(*inner, name + ".", out);
        else
            out.entries.push_back(entry_of(name, *node, out));
    }
}

static toml::table parsed_toml(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(
            fmt::format("{}: this is not TOML: {}; see docs/scene.md, or begin with "
                        "'jam_app new power-law'",
                        position(file, error.source()), error.description()));
    }
}

/// A value that is not TOML is taken as a word, so that the shell needs no second quotes.
static toml::table override_value(const std::string& text) {
    try {
        toml::table parsed = toml::parse("value = " + text);
        if (parsed.size() == 1) return parsed;
    } catch (const toml::parse_error&) {
    }
    return toml::table{{"value", text}};
}

static std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

static SceneEntry override_entry(const std::string& text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = trimmed(text.substr(0, equals));
    const std::string value = trimmed(text.substr(std::min(equals + 1, text.size())));
    require(!name.empty() && !value.empty(),
            "--set: {}: must be table.key=value; write for example --set protocol.pressure=1e-5",
            text);
    const toml::table parsed = override_value(value);
    const toml::node& node = *parsed.get("value");
    return {name, value_of(node), shown(node), "--set", {}};
}

static void replace_or_add(SceneEntry entry, std::vector<SceneEntry>& entries) {
    const auto at = std::ranges::find(entries, entry.name, &SceneEntry::name);
    if (at != entries.end())
        *at = std::move(entry);
    else
        entries.push_back(std::move(entry));
}

SceneEntries read_entries(std::string_view text, const std::filesystem::path& file,
                          std::span<const std::string> overrides) {
    SceneEntries out;
    out.file = file.string();
    add_table(parsed_toml(text, out.file), "", out);
    for (const std::string& one : overrides) replace_or_add(override_entry(one), out.entries);
    return out;
}

}  // namespace jam
