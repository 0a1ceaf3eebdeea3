// SPDX-License-Identifier: BSD-3-Clause
#include "packing/lammps_dump.h"

#include "core/check.h"
#include "core/whole_file.h"
#include "packing/line_reader.h"
#include "packing/particle_rows.h"

#include <fmt/compile.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>

namespace jam {

namespace {

/// By how much the box around a tilted cell exceeds it below and above, in x and in y (LAMMPS
/// manual, Howto triclinic).
struct Overhang {
    double below_x, above_x, below_y, above_y;
};

Overhang overhang(double xy, double xz, double yz) {
    return {std::min({0.0, xy, xz, xy + xz}), std::max({0.0, xy, xz, xy + xz}), std::min(0.0, yz),
            std::max(0.0, yz)};
}

struct Box {
    PeriodicCell cell;
    Vec3 origin;
};

/// What comes before a frame's rows.
struct Frame {
    Count step = 0;
    double time = 0.0;
    Count spheres = 0;
    std::optional<Box> box;
    std::vector<std::string> columns;
    LineReader::Place header_end;
};

void need_line(LineReader& lines, std::string_view what) {
    if (!lines.next()) lines.fail(fmt::format("the file ends where {} was expected", what));
}

void check_boundaries(const LineReader& lines, std::span<const std::string_view> words) {
    for (const std::string_view word : words)
        if (word != "pp")
            lines.fail(
                fmt::format("the boundary '{}' is not periodic; all three must be pp", word));
}

Box read_box(LineReader& lines) {
    std::vector<std::string_view> words = split(lines.line());
    words.erase(words.begin(), words.begin() + 3);  // ITEM: BOX BOUNDS
    const bool tilted = words.size() >= 3 && words[0] == "xy";
    if (!words.empty() && words[0] == "abc")
        lines.fail("the cell is general triclinic; write the dump with triclinic/general no");
    check_boundaries(lines, std::span(words).subspan(tilted ? 3 : 0));
    std::array<double, 3> low{}, high{}, tilt{};
    for (std::size_t k = 0; k < 3; ++k) {
        need_line(lines, "a line of box bounds");
        const std::vector<double> numbers = numbers_of(
            lines, tilted ? 3 : 2, tilted ? "lower bound, upper bound, tilt" : "the two bounds");
        low[k] = numbers[0];
        high[k] = numbers[1];
        if (tilted) tilt[k] = numbers[2];
    }
    const auto [xy, xz, yz] = tilt;
    const Overhang over = overhang(xy, xz, yz);
    const Vec3 origin(low[0] - over.below_x, low[1] - over.below_y, low[2]);
    Mat3 h;
    h << high[0] - over.above_x - origin[0], xy, xz,  //
        0.0, high[1] - over.above_y - origin[1], yz,  //
        0.0, 0.0, high[2] - origin[2];
    if (h.diagonal().minCoeff() <= 0.0)
        lines.fail(
            fmt::format("the cell's edges are {}, {}, {} long; all must be above zero, so "
                        "the bounds above are wrong",
                        h(0, 0), h(1, 1), h(2, 2)));
    return {PeriodicCell(h), origin};
}

Count read_count(LineReader& lines, std::string_view what) {
    need_line(lines, what);
    const auto number = parse_integer(lines.line());
    if (!number) lines.fail(fmt::format("'{}' was found, {} was expected", lines.line(), what));
    return *number;
}

/// Reads one section of a header, whose title is the current line.
void read_section(LineReader& lines, Frame& frame) {
    const std::string_view title = lines.line();
    if (title.starts_with("ITEM: TIMESTEP")) {
        frame.step = read_count(lines, "the number of the step");
    } else if (title.starts_with("ITEM: TIME")) {
        need_line(lines, "the time");
        frame.time = numbers_of(lines, 1, "the time")[0];
    } else if (title.starts_with("ITEM: NUMBER OF ATOMS")) {
        need_line(lines, "the number of atoms");
        frame.spheres = sphere_count_of(lines, lines.line());
    } else if (title.starts_with("ITEM: BOX BOUNDS")) {
        frame.box = read_box(lines);
    } else if (title.starts_with("ITEM: UNITS")) {
        need_line(lines, "the units");
    } else {
        lines.fail(
            fmt::format("'{}' was found, an ITEM of a LAMMPS dump was expected; give a file "
                        "that LAMMPS' dump custom wrote",
                        title.substr(0, 60)));
    }
}

/// Reads to the end of the next header; nothing at the end of the file.
std::optional<Frame> read_header(LineReader& lines) {
    if (!lines.next()) return std::nullopt;
    Frame frame;
    while (!lines.line().starts_with("ITEM: ATOMS")) {
        read_section(lines, frame);
        need_line(lines, "the next ITEM");
    }
    if (frame.spheres == 0 || !frame.box)
        lines.fail("ITEM: NUMBER OF ATOMS and ITEM: BOX BOUNDS must come before; add them");
    const std::vector<std::string_view> words = split(lines.line());
    frame.columns.assign(words.begin() + 2, words.end());
    frame.header_end = lines.place();
    return frame;
}

void skip_rows(LineReader& lines, const Frame& frame) {
    for (Count row = 0; row < frame.spheres; ++row)
        if (!lines.next() || lines.line().starts_with("ITEM:"))
            lines.fail(
                fmt::format("the frame of step {} ends after {} of {} atoms; write it again "
                            "or read another frame",
                            frame.step, row, frame.spheres));
}

/// The frame that is asked for; `lines` stands anywhere afterwards.
Frame find_frame(LineReader& lines, Count wanted) {
    std::optional<Frame> found;
    Count frames = 0;
    while (std::optional<Frame> frame = read_header(lines)) {
        found = std::move(frame);
        skip_rows(lines, *found);
        if (frames++ == wanted) return *found;
    }
    if (frames == 0) lines.fail("the file is empty; the first frame (ITEM: TIMESTEP) was expected");
    if (wanted != last_frame)
        lines.fail(
            fmt::format("the file holds {} frames, frame {} (from 0) was asked for; choose "
                        "another",
                        frames, wanted));
    return *found;
}

struct Columns {
    std::vector<Column> columns;
    bool scaled = false;  ///< positions in units of the cell's edges
};

/// "x", "y" or "z" for the names of positions, wrapped (x), unwrapped (xu), scaled (xs), or both
/// (xsu); any other name as it is.
std::string_view axis_of(std::string_view name) {
    const std::string_view kind = name.substr(std::min<std::size_t>(name.size(), 1));
    const bool is_position =
        name.find_first_of("xyz") == 0 && (kind == "u" || kind == "s" || kind == "su");
    return is_position ? name.substr(0, 1) : name;
}

Columns columns_of(const LineReader& lines, const Frame& frame) {
    Columns result;
    int scaled = 0;
    for (const std::string& name : frame.columns) {
        const std::string_view axis = axis_of(name);
        if (axis.size() < name.size() && name[1] == 's') ++scaled;
        result.columns.push_back(column_named(axis));
    }
    if (scaled != 0 && scaled != 3)
        lines.fail("some positions are scaled and some are not; write x y z or xs ys zs");
    result.scaled = scaled == 3;
    return result;
}

}  // namespace

Packing read_lammps_dump(const std::filesystem::path& path, Count frame_number) {
    LineReader lines(path);
    const Frame frame = find_frame(lines, frame_number);
    lines.go_to(frame.header_end);
    const auto [columns, scaled] = columns_of(lines, frame);
    ParticleRows rows(lines, columns);
    Packing packing;
    packing.cell = frame.box->cell;
    packing.step = frame.step;
    packing.time = frame.time;
    for (Count row = 0; row < frame.spheres; ++row) {
        lines.next();
        rows.add(lines, packing);
    }
    rows.finish(lines, packing);
    for (Vec3& position : packing.positions)
        position = scaled ? packing.cell.cartesian(position) : position - frame.box->origin;
    return packing;
}

void write_lammps_dump(const Packing& packing, const std::filesystem::path& path) {
    check_packing(packing);
    const Mat3& h = packing.cell.matrix();
    const double xy = h(0, 1), xz = h(0, 2), yz = h(1, 2);
    const Overhang over = overhang(xy, xz, yz);
    const std::int64_t shift = shift_to_positive(packing);
    const bool moving = !packing.velocities.empty();
    write_whole_file(path, [&](FileSink& sink) {
        fmt::memory_buffer text;
        const auto out = std::back_inserter(text);
        fmt::format_to(out, "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", packing.step,
                       packing.size());
        fmt::format_to(out, "ITEM: BOX BOUNDS xy xz yz pp pp pp\n{} {} {}\n{} {} {}\n0 {} {}\n",
                       over.below_x, h(0, 0) + over.above_x, xy, over.below_y,
                       h(1, 1) + over.above_y, xz, h(2, 2), yz);
        fmt::format_to(out, "ITEM: ATOMS id type diameter x y z{}\n", moving ? " vx vy vz" : "");
        for (std::size_t i = 0; i < packing.positions.size(); ++i) {
            const Vec3& x = packing.positions[i];
            fmt::format_to(out, FMT_COMPILE("{} 1 {} {} {} {}"), packing.ids[i] + shift,
                           packing.diameters[i], x[0], x[1], x[2]);
            if (moving) {
                const Vec3& v = packing.velocities[i];
                fmt::format_to(out, FMT_COMPILE(" {} {} {}"), v[0], v[1], v[2]);
            }
            text.push_back('\n');
            sink.write({text.data(), text.size()});
            text.clear();
        }
    });
}

}  // namespace jam
