// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/sweep_file.h"

#include "core/check.h"
#include "jamming/scene_entries.h"
#include "jamming/scene_file.h"
#include "packing/packing_io.h"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace jam {

namespace fs = std::filesystem;

namespace {

/// One value of a key of the grid.
struct GridValue {
    std::string text;   ///< as TOML
    std::string where;  ///< "file:line:column"
};

struct GridKey {
    std::string name;  ///< "table.key"
    std::string where;
    std::vector<GridValue> values;
};

struct SweepReading {
    fs::path file;
    std::string text;
    toml::table table;
    std::vector<std::string> mistakes;  ///< each once

    void add(const std::string& mistake) {
        if (std::ranges::find(mistakes, mistake) == mistakes.end()) mistakes.push_back(mistake);
    }
    void throw_if_any() const {
        if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
    }
    std::string place(const toml::source_region& source) const {
        return fmt::format("{}:{}:{}", file.string(), source.begin.line, source.begin.column);
    }
};

std::string content_of(const fs::path& file, const std::string& mistake) {
    std::ifstream in(file, std::ios::binary);
    require(in && fs::is_regular_file(file), "{}", mistake);
    return {std::istreambuf_iterator<char>(in), {}};
}

SweepReading begin(const fs::path& file) {
    SweepReading reading;
    reading.file = file;
    reading.text = content_of(
        file, fmt::format("{}: must be a sweep file that can be read; docs/sweeps.md has one to "
                          "begin with",
                          file.string()));
    try {
        reading.table = toml::parse(reading.text, file.string());
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}: this is not TOML: {}; see docs/sweeps.md",
                                     reading.place(error.source()), error.description()));
    }
    return reading;
}

/// A value as TOML on one line, numbers as people write them.
std::string text_of(const toml::node& node) {
    if (const auto* number = node.as_floating_point()) return number_text(number->get());
    if (const auto* array = node.as_array()) {
        std::vector<std::string> items;
        for (const toml::node& item : *array) items.push_back(text_of(item));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    std::string text = out.str();
    std::ranges::replace(text, '\n', ' ');
    return text;
}

// --- [grid] -------------------------------------------------------------------------------------

void add_grid(const toml::table& table, const std::string& prefix, SweepReading& reading,
              std::vector<GridKey>& grid) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        if (const auto* inner = node.as_table()) {
            add_grid(*inner, name + ".", reading, grid);
            continue;
        }
        GridKey entry{name, reading.place(key.source()), {}};
        if (const auto* values = node.as_array())
            for (const toml::node& value : *values)
                entry.values.push_back({text_of(value), reading.place(value.source())});
        if (entry.values.empty())
            reading.add(
                fmt::format("{}: grid.{} = {}: must be a list of values; write for example "
                            "run.seed = [1, 2, 3]",
                            entry.where, name, text_of(node)));
        if (name == "run.output")
            reading.add(
                fmt::format("{}: grid.run.output: each run has a folder of its own; remove "
                            "it, and set sweep.output",
                            entry.where));
        grid.push_back(std::move(entry));
    }
}

/// Line and column of "file:line:column", to bring what toml++ sorts by name in the file's order.
std::pair<long, long> line_and_column(const std::string& where) {
    const std::size_t column = where.rfind(':');
    const std::size_t line = where.rfind(':', column - 1);
    return {std::stol(where.substr(line + 1)), std::stol(where.substr(column + 1))};
}

std::vector<GridKey> read_grid(SweepReading& reading) {
    std::vector<GridKey> grid;
    const toml::table* table = reading.table["grid"].as_table();
    if (!table || table->empty())
        reading.add(
            fmt::format("{}: [grid]: missing; a sweep needs at least one key with a list of "
                        "values; write for example [grid] with run.seed = [1, 2, 3]",
                        reading.file.string()));
    else
        add_grid(*table, "", reading, grid);
    std::ranges::sort(grid, {}, [](const GridKey& key) { return line_and_column(key.where); });
    return grid;
}

// --- [sweep] ------------------------------------------------------------------------------------

/// A number of [sweep] between 0 and `most`.
template <typename Number>
void read_number(const toml::table& table, std::string_view key, double most, Number& number,
                 SweepReading& reading) {
    const toml::node* node = table.get(key);
    if (!node) return;
    const auto value = node->value<double>();
    const bool whole = std::is_floating_point_v<Number> || node->is_integer();
    if (node->is_number() && whole && *value >= 0.0 && *value <= most)
        number = static_cast<Number>(*value);
    else
        reading.add(
            fmt::format("{}: sweep.{} = {}: must be a {}number from 0 to {}; 0 leaves it to "
                        "the machine",
                        reading.place(node->source()), key, text_of(*node),
                        std::is_floating_point_v<Number> ? "" : "whole ", most));
}

void read_output(const toml::table& table, Sweep& sweep, SweepReading& reading) {
    const toml::node* node = table.get("output");
    if (!node) return;
    const auto folder = node->value<std::string>();
    if (node->is_string() && !folder->empty())
        sweep.output = *folder;
    else
        reading.add(
            fmt::format("{}: sweep.output = {}: must be a path in quotes; write for example "
                        "output = \"runs/mine\"",
                        reading.place(node->source()), text_of(*node)));
}

void read_settings(SweepReading& reading, Sweep& sweep) {
    sweep.output = "runs" / reading.file.stem();
    const toml::table* table = reading.table["sweep"].as_table();
    if (!table) return;
    read_number(*table, "threads", 4096, sweep.threads, reading);
    read_number(*table, "threads_a_run", 4096, sweep.threads_a_run, reading);
    read_number(*table, "memory", 1e6, sweep.memory, reading);
    read_output(*table, sweep, reading);
    for (const auto& [key, node] : *table)
        if (const auto name = key.str();
            name != "output" && name != "threads" && name != "threads_a_run" && name != "memory")
            reading.add(
                fmt::format("{}: sweep.{}: no such key; there are output, threads, "
                            "threads_a_run and memory",
                            reading.place(key.source()), name));
}

// --- the scene ----------------------------------------------------------------------------------

/// Text and place of the scene that the grid starts from.
struct Base {
    std::string text;
    fs::path file;
};

Base read_base(SweepReading& reading) {
    const toml::node* named = reading.table.get("scene");
    if (!named) return {reading.text, reading.file};
    const std::string where = reading.place(named->source());
    const auto name = named->value<std::string>();
    require(named->is_string() && !name->empty(),
            "{}: scene = {}: must be the path of a scene file in quotes; correct it", where,
            text_of(*named));
    const fs::path file = reading.file.parent_path() / *name;
    for (const auto& [key, node] : reading.table)
        if (const auto table = key.str(); table != "grid" && table != "sweep" && table != "scene")
            reading.add(
                fmt::format("{}: {}: a sweep has its scene in a file or in itself, not "
                            "both; remove it, or remove scene = \"{}\"",
                            reading.place(key.source()), table, *name));
    return {content_of(file, fmt::format("{}: scene = \"{}\": must be a scene file that can be "
                                         "read, and {} is none; correct the path",
                                         where, *name, file.string())),
            file};
}

/// Keys of the sweep itself, which no scene has.
bool is_of_sweep(const SceneEntry& entry) {
    return entry.name == "grid" || entry.name == "sweep" || entry.name.starts_with("grid.") ||
           entry.name.starts_with("sweep.");
}

Scene scene_of(const Base& base, const std::vector<GridKey>& grid,
               const std::vector<std::size_t>& choice, const SweepReading& reading) {
    std::vector<std::string> overrides;
    for (std::size_t k = 0; k < grid.size(); ++k)
        overrides.push_back(grid[k].name + "=" + grid[k].values[choice[k]].text);
    SceneEntries entries = read_entries(base.text, base.file, overrides);
    std::erase_if(entries.entries, is_of_sweep);
    for (SceneEntry& entry : entries.entries) {
        const auto key = std::ranges::find(grid, entry.name, &GridKey::name);
        if (key == grid.end()) continue;
        entry.where = key->values[choice[static_cast<std::size_t>(key - grid.begin())]].where;
        entry.folder = reading.file.parent_path();
    }
    return scene_from(std::move(entries));
}

// --- the runs -----------------------------------------------------------------------------------

/// "key" of "table.key", unless another key of the grid ends the same way.
std::string short_name(const GridKey& key, const std::vector<GridKey>& grid) {
    const auto last = [](const std::string& name) { return name.substr(name.rfind('.') + 1); };
    const auto same = std::ranges::count_if(
        grid, [&](const GridKey& other) { return last(other.name) == last(key.name); });
    return same == 1 ? last(key.name) : key.name;
}

/// A text as a part of a file name.
std::string in_file_name(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool plain =
            std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
        if (plain)
            out += c;
        else if (std::string_view("\"' []").find(c) == std::string_view::npos)
            out += c == ',' ? '_' : '-';
    }
    return out;
}

std::string run_name(const std::vector<GridKey>& grid, const std::vector<std::size_t>& choice) {
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < grid.size(); ++k)
        parts.push_back(fmt::format("{}={}", short_name(grid[k], grid),
                                    in_file_name(grid[k].values[choice[k]].text)));
    return fmt::format("{}", fmt::join(parts, "_"));
}

/// The next combination, the last key fastest; false after the last one.
bool advance(std::vector<std::size_t>& choice, const std::vector<GridKey>& grid) {
    for (std::size_t k = grid.size(); k-- > 0;) {
        if (++choice[k] < grid[k].values.size()) return true;
        choice[k] = 0;
    }
    return false;
}

void add_lines(const std::string& text, SweepReading& reading) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) reading.add(line);
}

void add_runs(const Base& base, const std::vector<GridKey>& grid, SweepReading& reading,
              Sweep& sweep) {
    constexpr double most_runs = 100'000;
    double count = 1.0;
    for (const GridKey& key : grid) count *= static_cast<double>(key.values.size());
    require(count <= most_runs, "{}: [grid]: asks for {} runs; must be at most {}; shorten a list",
            reading.file.string(), count, most_runs);
    std::set<std::string> names;
    std::vector<std::size_t> choice(grid.size(), 0);
    do {
        SweepRun run;
        run.name = run_name(grid, choice);
        if (!names.insert(run.name).second)
            reading.add(
                fmt::format("{}: [grid]: two runs would have the name {}; remove the value "
                            "that stands twice",
                            reading.file.string(), run.name));
        try {
            run.scene = scene_of(base, grid, choice, reading);
        } catch (const InputError& error) {
            add_lines(error.what(), reading);
        }
        run.scene.run.output = sweep.output / run.name;
        sweep.runs.push_back(std::move(run));
    } while (advance(choice, grid));
}

}  // namespace

Sweep read_sweep(const fs::path& file) {
    SweepReading reading = begin(file);
    Sweep sweep;
    read_settings(reading, sweep);
    const std::vector<GridKey> grid = read_grid(reading);
    const Base base = read_base(reading);
    reading.throw_if_any();
    add_runs(base, grid, reading, sweep);
    reading.throw_if_any();
    return sweep;
}

double memory_of_run(const Scene& scene) {
    constexpr double program = 30e6;
    constexpr double a_particle = 1000.0;  // docs/handoff.md has the measurement
    const Count particles = scene.start.packing.empty() ? particle_count(scene.sizes)
                                                        : read_packing(scene.start.packing).size();
    return program + a_particle * static_cast<double>(particles);
}

}  // namespace jam
