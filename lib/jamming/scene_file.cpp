// SPDX-License-Identifier: BSD-3-Clause
// From entries to a scene: every key by its own rule, then the rules between keys.
#include "jamming/scene_file.h"

#include "core/check.h"
#include "jamming/scene_entries.h"
#include "jamming/scene_keys.h"
#include "jamming/scene_mistakes.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace jam {

namespace {

/// What is known while a scene is read.
struct Reading {
    SceneEntries source;
    SceneDraft draft;
    std::set<std::string> broken;  ///< keys whose value broke their rule
    SceneMistakes mistakes;

    void add(const SceneEntry& entry, const std::string& what) {
        mistakes.add(entry.where, fmt::format("{} = {}: {}", entry.name, entry.text, what));
    }
    bool has(std::string_view key) const { return source.find(key) != nullptr; }
    bool sound(std::string_view table) const {
        return std::ranges::none_of(broken,
                                    [&](const std::string& key) { return key.starts_with(table); });
    }
    /// Where a key that is not there would stand.
    std::string place_of(const std::string& key) const {
        const auto table = source.tables.find(key.substr(0, key.find('.')));
        return table == source.tables.end() ? source.file : table->second;
    }
};

}  // namespace

static std::string unknown_key(const SceneEntry& entry) {
    if (entry.name.find('.') == std::string::npos)
        for (const SceneKey& key : scene_keys())
            if (key.name.starts_with(entry.name + "."))
                return fmt::format("must be a table; write [{}]", entry.name);
    const std::string nearest = nearest_scene_key(entry.name);
    return nearest.empty() ? "no such key; docs/scene.md and 'jam_app keys' list them all"
                           : fmt::format("no such key; did you mean {}?", nearest);
}

static void read_entry(const SceneEntry& entry, Reading& reading) {
    const SceneKey* key = find_scene_key(entry.name);
    if (!key) {
        reading.add(entry, unknown_key(entry));
        return;
    }
    if (key->field.set(reading.draft, entry.value)) return;
    reading.broken.insert(entry.name);
    reading.add(entry, fmt::format("must be {}; write for example {} = {}", key->field.rule,
                                   key->name, toml_text(key->example)));
}

/// Paths of input files are meant from where they were written.
static void resolve_path(std::string_view key, std::filesystem::path& path, Reading& reading) {
    const SceneEntry* entry = reading.source.find(key);
    if (!entry || path.empty()) return;
    path = std::filesystem::absolute(entry->folder / path).lexically_normal();
    if (std::filesystem::is_regular_file(path)) return;
    reading.broken.insert(entry->name);
    reading.add(*entry, fmt::format("must be a file that can be read, and {} is none; correct "
                                    "the path",
                                    path.string()));
}

// --- table [sizes] ------------------------------------------------------------------------------

static void check_no_sizes_with_packing(Reading& reading) {
    for (const SceneEntry& entry : reading.source.entries)
        if (entry.name.starts_with("sizes.") || entry.name == "start.volume_fraction")
            reading.add(entry,
                        "has no meaning beside start.packing, whose particles are taken as "
                        "they are; remove one of the two");
}

static bool is_given(const std::string& key, const Reading& reading) {
    return reading.has(key) || (key == "sizes.alpha" && reading.has("sizes.beta"));
}

/// Adds what is missing; true if nothing is.
static bool check_required_sizes(const SizesKind& kind, Reading& reading) {
    bool complete = true;
    for (const std::string& name : kind.required) {
        if (is_given(name, reading)) continue;
        complete = false;
        const SceneKey& key = *find_scene_key(name);
        reading.mistakes.add(reading.place_of(name),
                             fmt::format("{}: missing; sizes.kind = \"{}\" needs it: {}, {}; write "
                                         "for example {} = {}",
                                         name, kind.name, key.meaning, key.field.rule, name,
                                         toml_text(key.example)));
    }
    return complete;
}

static void check_foreign_sizes(const SizesKind& kind, Reading& reading) {
    for (const SceneEntry& entry : reading.source.entries) {
        const SceneKey* key = find_scene_key(entry.name);
        if (!key || !entry.name.starts_with("sizes.") || kind.takes(entry.name)) continue;
        reading.add(entry,
                    fmt::format("does not belong to sizes.kind = \"{}\" but to {}; remove it",
                                kind.name, fmt::join(kinds_that_use(*key), ", ")));
    }
}

static void check_one_exponent(Reading& reading) {
    if (reading.has("sizes.alpha") && reading.has("sizes.beta"))
        reading.add(*reading.source.find("sizes.beta"),
                    fmt::format("beta = 4 - alpha, and sizes.alpha = {} is given, too; remove one "
                                "of the two",
                                reading.source.find("sizes.alpha")->text));
}

/// The distribution's own check of values that each keep their rule.
static void build_sizes(Reading& reading) {
    SizesSettings& sizes = reading.draft.scene.sizes;
    try {
        sizes = settings_of(reading.draft.sizes);
        check(sizes.distribution);
        check_particle_count(particle_count(sizes));
    } catch (const std::runtime_error& error) {  // InputError or FileError, of a table
        reading.mistakes.add(reading.place_of("sizes.kind"), error.what());
    }
}

static void read_sizes(Reading& reading) {
    if (!reading.sound("sizes.kind")) return;
    const SizesKind* kind = find_sizes_kind(reading.draft.sizes.kind);
    if (!kind) {
        const SceneKey& key = *find_scene_key("sizes.kind");
        reading.mistakes.add(
            reading.place_of(key.name),
            fmt::format("{}: missing; must be {}; write for example {} = {}", key.name,
                        key.field.rule, key.name, toml_text(key.example)));
        return;
    }
    check_foreign_sizes(*kind, reading);
    check_one_exponent(reading);
    if (check_required_sizes(*kind, reading) && reading.sound("sizes.")) build_sizes(reading);
}

// --- rules between keys -------------------------------------------------------------------------

static void check_pressure(Reading& reading) {
    const SceneEntry* entry = reading.source.find("protocol.pressure");
    const Scene& scene = reading.draft.scene;
    const Mat3& pressure = scene.protocol.pressure;
    if (!reading.sound("protocol.") || !reading.sound("contact.stiffness")) return;
    const std::string where = entry ? entry->where : reading.place_of("protocol.pressure");
    const std::string shown =
        toml_text(*find_scene_key("protocol.pressure")->field.get(reading.draft));
    const auto refuse = [&](const std::string& what) {
        reading.mistakes.add(where, fmt::format("protocol.pressure = {}: {}", shown, what));
    };
    if (pressure.cwiseAbs().maxCoeff() > scene.contact.stiffness)
        refuse(
            fmt::format("must not exceed contact.stiffness = {}: the spheres would overlap by "
                        "their whole diameter; lower the pressure",
                        scene.contact.stiffness));
    const bool sheared = !pressure.isDiagonal(0.0);
    if (sheared && scene.protocol.free_cell != FreeCell::all)
        refuse("a shear stress needs a cell that can tilt; set protocol.free_cell = \"all\"");
    const bool isotropic = pressure == Mat3(Mat3::Identity() * pressure(0, 0));
    if (!sheared && !isotropic && scene.protocol.free_cell == FreeCell::isotropic)
        refuse(
            "different pressures need edges that change apart; set protocol.free_cell = "
            "\"orthogonal\" or \"all\"");
}

constexpr std::string_view accuracy_key = "protocol.accuracy";

/// Before all other keys, which it gives their defaults.
static void read_accuracy(Reading& reading) {
    const SceneEntry* entry = reading.source.find(accuracy_key);
    if (!entry) return;
    read_entry(*entry, reading);
    take_defaults_of_accuracy(reading.draft.scene);
}

Scene scene_from(SceneEntries entries) {
    Reading reading;
    reading.source = std::move(entries);
    read_accuracy(reading);
    for (const SceneEntry& entry : reading.source.entries)
        if (entry.name != accuracy_key) read_entry(entry, reading);
    resolve_path("sizes.file", reading.draft.sizes.file, reading);
    resolve_path("start.packing", reading.draft.scene.start.packing, reading);
    if (reading.has("start.packing"))
        check_no_sizes_with_packing(reading);
    else
        read_sizes(reading);
    check_pressure(reading);
    reading.mistakes.throw_if_any();
    return reading.draft.scene;
}

// --- in ------------------------------------------------------------------------------------------

Scene parse_scene(std::string_view text, const std::filesystem::path& file,
                  std::span<const std::string> overrides) {
    return scene_from(read_entries(text, file, overrides));
}

Scene read_scene(const std::filesystem::path& file, std::span<const std::string> overrides) {
    std::ifstream in(file, std::ios::binary);
    require(in && std::filesystem::is_regular_file(file),
            "{}: must be a scene file that can be read; correct the path, or write one with "
            "'jam_app new power-law > {}'",
            file.string(), file.string());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return parse_scene(text, file, overrides);
}

}  // namespace jam
