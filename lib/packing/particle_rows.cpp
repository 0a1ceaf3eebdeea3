// SPDX-License-Identifier: BSD-3-Clause
#include "packing/particle_rows.h"

#include "core/check.h"
#include "core/parallel.h"
#include "core/particle_limit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace jam {

namespace {

constexpr std::array<std::pair<std::string_view, Column>, 10> names = {{
    {"id", Column::id},
    {"diameter", Column::diameter},
    {"radius", Column::radius},
    {"x", Column::x},
    {"y", Column::y},
    {"z", Column::z},
    {"vx", Column::vx},
    {"vy", Column::vy},
    {"vz", Column::vz},
    {"density", Column::density},
}};

std::string_view name_of(Column column) {
    for (const auto& [name, named] : names)
        if (named == column) return name;
    return "";
}

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/// Takes the first word off `rest`; empty when a blank-separated line has no more.
std::string_view take_word(std::string_view& rest, char separator) {
    if (separator == ' ')
        while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    std::size_t end = 0;
    while (end < rest.size() && (separator == ' ' ? !is_blank(rest[end]) : rest[end] != separator))
        ++end;
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end + 1));
    return word;
}

std::string_view without_blanks(std::string_view word) {
    while (!word.empty() && is_blank(word.front())) word.remove_prefix(1);
    while (!word.empty() && is_blank(word.back())) word.remove_suffix(1);
    return word;
}

template <typename Number>
std::optional<Number> parse(std::string_view word) {
    word = without_blanks(word);
    if (word.starts_with('+')) word.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

/// One row as it is read.
struct Row {
    std::int64_t id = 0;
    double diameter = 0.0;
    double density = 0.0;
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
};

double number_in(const LineReader& lines, Column column, std::string_view word) {
    const std::optional<double> number = parse_number(word);
    if (!number)
        lines.fail(fmt::format("{} is '{}'; it must be a finite number", name_of(column), word));
    return *number;
}

double positive_in(const LineReader& lines, Column column, std::string_view word) {
    const double number = number_in(lines, column, word);
    if (number <= 0.0)
        lines.fail(fmt::format("{} is {}; it must be above zero", name_of(column), word));
    return number;
}

std::int64_t id_in(const LineReader& lines, std::string_view word) {
    const std::optional<std::int64_t> id = parse_integer(word);
    if (!id) lines.fail(fmt::format("id is '{}'; it must be a whole number", word));
    return *id;
}

void store(const LineReader& lines, Column column, std::string_view word, Row& row) {
    switch (column) {
        case Column::ignored:
            return;
        case Column::id:
            row.id = id_in(lines, word);
            return;
        case Column::diameter:
            row.diameter = positive_in(lines, column, word);
            return;
        case Column::radius:
            row.diameter = 2.0 * positive_in(lines, column, word);
            return;
        case Column::x:
            row.position[0] = number_in(lines, column, word);
            return;
        case Column::y:
            row.position[1] = number_in(lines, column, word);
            return;
        case Column::z:
            row.position[2] = number_in(lines, column, word);
            return;
        case Column::vx:
            row.velocity[0] = number_in(lines, column, word);
            return;
        case Column::vy:
            row.velocity[1] = number_in(lines, column, word);
            return;
        case Column::vz:
            row.velocity[2] = number_in(lines, column, word);
            return;
        case Column::density:
            row.density = positive_in(lines, column, word);
            return;
    }
}

}  // namespace

Column column_named(std::string_view name) {
    for (const auto& [known, column] : names)
        if (known == name) return column;
    return Column::ignored;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
    std::vector<std::string_view> words;
    while (!line.empty()) {
        const std::string_view word = without_blanks(take_word(line, separator));
        if (separator != ' ' || !word.empty()) words.push_back(word);
    }
    return words;
}

std::optional<double> parse_number(std::string_view word) {
    const std::optional<double> number = parse<double>(word);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
    return parse<std::int64_t>(word);
}

std::vector<double> numbers_of(const LineReader& lines, std::size_t count, std::string_view what) {
    std::vector<double> numbers;
    for (const std::string_view word : split(lines.line()))
        if (const std::optional<double> number = parse_number(word)) numbers.push_back(*number);
    if (numbers.size() != count || split(lines.line()).size() != count)
        lines.fail(fmt::format("'{}' was found, {} was expected ({} finite numbers); correct it",
                               lines.line(), what, count));
    return numbers;
}

Count sphere_count_of(const LineReader& lines, std::string_view word) {
    const std::optional<std::int64_t> count = parse_integer(word);
    if (!count || *count < 1 || *count > max_particle_count)
        lines.fail(fmt::format("'{}' is not a number of spheres; it must be 1 to {}", word,
                               max_particle_count));
    return *count;
}

ParticleRows::ParticleRows(const LineReader& lines, std::vector<Column> columns, char separator)
    : columns_(std::move(columns)), separator_(separator) {
    for (const auto& [name, column] : names)
        if (std::count(columns_.begin(), columns_.end(), column) > 1)
            lines.fail(fmt::format("two columns hold {}; leave one", name));
    if (has(Column::diameter) == has(Column::radius))
        lines.fail("no column holds the size of the spheres, or two do; give diameter or radius");
    if (!has(Column::x) || !has(Column::y) || !has(Column::z))
        lines.fail("the columns x, y and z must all be there; write the file with them");
    if (has(Column::vx) != has(Column::vy) || has(Column::vy) != has(Column::vz))
        lines.fail("of vx, vy and vz some are missing; give all or none");
}

bool ParticleRows::has(Column column) const {
    return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

void ParticleRows::add(const LineReader& lines, Packing& packing) {
    if (packing.positions.empty()) first_line_ = lines.number();
    Row row;
    row.id = packing.size() + 1;
    std::string_view rest = lines.line();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const std::string_view word = take_word(rest, separator_);
        if (word.empty())
            lines.fail(fmt::format("{} of {} columns were found; every sphere needs them all", k,
                                   columns_.size()));
        store(lines, columns_[k], word, row);
    }
    if (!without_blanks(rest).empty())
        lines.fail(fmt::format("more than {} columns were found; every sphere has the same ones",
                               columns_.size()));
    packing.ids.push_back(row.id);
    packing.diameters.push_back(row.diameter);
    packing.positions.push_back(row.position);
    if (has(Column::vx)) packing.velocities.push_back(row.velocity);
    if (!has(Column::density)) return;
    if (density_ && *density_ != row.density)
        lines.fail(
            fmt::format("density is {}, where earlier spheres have {}; a packing has one "
                        "density",
                        row.density, *density_));
    density_ = row.density;
}

void ParticleRows::finish(const LineReader& lines, const Packing& packing) const {
    if (packing.ids.empty()) lines.fail("no spheres follow; a packing has at least one");
    std::vector<std::pair<std::int64_t, Count>> by_id(packing.ids.size());
    for (std::size_t i = 0; i < by_id.size(); ++i)
        by_id[i] = {packing.ids[i], first_line_ + static_cast<Count>(i)};
    sort_total_order(by_id, std::less<>());
    const auto twice =
        std::adjacent_find(by_id.begin(), by_id.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != by_id.end())
        lines.fail(fmt::format("lines {} and {} both have the id {}; ids must be distinct",
                               twice->second, (twice + 1)->second, twice->first));
}

std::int64_t shift_to_positive(const Packing& packing) {
    const std::int64_t smallest = *std::min_element(packing.ids.begin(), packing.ids.end());
    return smallest < 1 ? 1 - smallest : 0;
}

}  // namespace jam
