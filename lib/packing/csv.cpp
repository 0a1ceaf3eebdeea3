// SPDX-License-Identifier: BSD-3-Clause
#include "packing/csv.h"

#include "core/check.h"
#include "core/whole_file.h"
#include "packing/line_reader.h"
#include "packing/particle_rows.h"

#include <fmt/compile.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace jam {

namespace {

constexpr std::string_view cell_key = "cell:";
constexpr std::string_view cell_line = "# cell: ax ay az bx by bz cx cy cz";

/// The cell, if the comment on the current line holds it.
std::optional<PeriodicCell> cell_in_comment(const LineReader& lines) {
    const std::size_t at = lines.line().find(cell_key);
    if (at == std::string_view::npos) return std::nullopt;
    std::vector<double> edges;
    for (const std::string_view word : split(lines.line().substr(at + cell_key.size())))
        edges.push_back(parse_number(word).value_or(std::nan("")));
    if (edges.size() != 9)
        lines.fail(fmt::format("'{}' with nine numbers was expected; correct it", cell_line));
    try {
        return PeriodicCell(Eigen::Map<const Mat3>(edges.data()));
    } catch (const InputError& error) {
        lines.fail(error.what());
    }
}

/// Reads up to and including the line of column names, and the cell on the way.
PeriodicCell read_cell(LineReader& lines) {
    std::optional<PeriodicCell> cell;
    while (lines.next() && lines.line().starts_with('#'))
        if (!cell) cell = cell_in_comment(lines);
    if (!cell)
        lines.fail(
            fmt::format("a comment line '{}' was expected before the names of the columns; "
                        "add it",
                        cell_line));
    return *cell;
}

/// Blank lines may only end the file.
bool next_row(LineReader& lines) {
    if (!lines.next()) return false;
    if (!split(lines.line()).empty()) return true;
    while (lines.next())
        if (!split(lines.line()).empty())
            lines.fail("a line of numbers follows an empty line; take the empty one out");
    return false;
}

}  // namespace

Packing read_csv(const std::filesystem::path& path) {
    LineReader lines(path);
    Packing packing;
    packing.cell = read_cell(lines);
    std::vector<Column> columns;
    for (const std::string_view name : split(lines.line(), ','))
        columns.push_back(column_named(name));
    ParticleRows rows(lines, std::move(columns), ',');
    while (next_row(lines)) rows.add(lines, packing);
    rows.finish(lines, packing);
    return packing;
}

void write_csv(const Packing& packing, const std::filesystem::path& path) {
    check_packing(packing);
    const Mat3& h = packing.cell.matrix();
    const bool moving = !packing.velocities.empty();
    write_whole_file(path, [&](FileSink& sink) {
        fmt::memory_buffer text;
        const auto out = std::back_inserter(text);
        fmt::format_to(out, "# spheres in a periodic cell, whose edges are a, b and c\n# {} {}\n",
                       cell_key, fmt::join(h.data(), h.data() + 9, " "));
        fmt::format_to(out, "id,diameter,x,y,z{}\n", moving ? ",vx,vy,vz" : "");
        for (std::size_t i = 0; i < packing.positions.size(); ++i) {
            const Vec3& x = packing.positions[i];
            fmt::format_to(out, FMT_COMPILE("{},{},{},{},{}"), packing.ids[i], packing.diameters[i],
                           x[0], x[1], x[2]);
            if (moving) {
                const Vec3& v = packing.velocities[i];
                fmt::format_to(out, FMT_COMPILE(",{},{},{}"), v[0], v[1], v[2]);
            }
            text.push_back('\n');
            sink.write({text.data(), text.size()});
            text.clear();
        }
    });
}

}  // namespace jam
