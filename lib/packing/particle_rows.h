// SPDX-License-Identifier: BSD-3-Clause
// What the exchange formats have in common: one line a sphere, in columns whose meaning is known.
#pragma once

#include "packing/line_reader.h"
#include "packing/packing.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace jam {

/// What a column holds.
enum class Column { ignored, id, diameter, radius, x, y, z, vx, vy, vz, density };

/// "id", "diameter", "x", ...: the column of that name; `ignored` for any other.
Column column_named(std::string_view name);

/// Splits at blanks, or at each `separator` if that is not a blank.
std::vector<std::string_view> split(std::string_view line, char separator = ' ');

/// The number that `word` is, or nothing. Finite ones only.
std::optional<double> parse_number(std::string_view word);
std::optional<std::int64_t> parse_integer(std::string_view word);

/// The words of the current line as numbers. Throws InputError, which names `what`, unless there
/// are `count` of them.
std::vector<double> numbers_of(const LineReader& lines, std::size_t count, std::string_view what);

/// A number of spheres that memory and indices can hold. Throws InputError.
Count sphere_count_of(const LineReader& lines, std::string_view word);

/// The columns of a table of spheres and how they are separated.
class ParticleRows {
  public:
    /// Throws InputError, at the current line of `lines`, unless there are a diameter or a radius,
    /// x, y and z, no column twice, and all of vx, vy, vz or none.
    ParticleRows(const LineReader& lines, std::vector<Column> columns, char separator = ' ');

    /// Adds the sphere of the current line. Ids are 1, 2, ... where no column holds them.
    void add(const LineReader& lines, Packing& packing);

    /// Throws InputError if two spheres have one id, or none was added. Call it after the last row;
    /// rows stand on consecutive lines.
    void finish(const LineReader& lines, const Packing& packing) const;

    /// The density that all rows agree on, if there is such a column.
    std::optional<double> density() const { return density_; }

  private:
    bool has(Column column) const;

    std::vector<Column> columns_;
    char separator_;
    Count first_line_ = 0;
    std::optional<double> density_;
};

/// What is added to each id so that the smallest is at least 1, as LAMMPS asks.
std::int64_t shift_to_positive(const Packing& packing);

}  // namespace jam
