// SPDX-License-Identifier: BSD-3-Clause
#include "packing/extended_xyz.h"

#include "core/check.h"
#include "core/whole_file.h"
#include "packing/line_reader.h"
#include "packing/particle_rows.h"

#include <fmt/compile.h>

#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <string>

namespace jam {

namespace {

using Keys = std::map<std::string, std::string, std::less<>>;

/// key=value and key="several values", separated by blanks.
Keys keys_of(std::string_view comment) {
    Keys keys;
    while (true) {
        comment.remove_prefix(std::min(comment.find_first_not_of(" \t"), comment.size()));
        if (comment.empty()) return keys;
        const std::size_t key_end = std::min(comment.find_first_of("= \t"), comment.size());
        const std::string key(comment.substr(0, key_end));
        comment.remove_prefix(key_end);
        if (!comment.starts_with('=')) continue;
        comment.remove_prefix(1);
        const bool quoted = comment.starts_with('"');
        if (quoted) comment.remove_prefix(1);
        const std::size_t end =
            std::min(quoted ? comment.find('"') : comment.find_first_of(" \t"), comment.size());
        keys[key] = comment.substr(0, end);
        comment.remove_prefix(std::min(end + 1, comment.size()));
    }
}

template <std::size_t count>
std::optional<std::array<double, count>> numbers_in(const Keys& keys, std::string_view key) {
    const auto found = keys.find(key);
    if (found == keys.end()) return std::nullopt;
    const auto words = split(found->second);
    std::array<double, count> numbers{};
    for (std::size_t k = 0; k < count; ++k) {
        const auto number = k < words.size() ? parse_number(words[k]) : std::nullopt;
        if (!number) return std::nullopt;
        numbers[k] = *number;
    }
    return words.size() == count ? std::optional(numbers) : std::nullopt;
}

PeriodicCell cell_of(const LineReader& lines, const Keys& keys) {
    const auto edges = numbers_in<9>(keys, "Lattice");
    if (!edges)
        lines.fail(
            "Lattice=\"ax ay az bx by bz cx cy cz\" was expected, nine finite numbers; this "
            "is not an extended XYZ file with a cell");
    const auto periodic = keys.find("pbc");
    if (periodic != keys.end() && periodic->second.find_first_of("Ff0") != std::string::npos)
        lines.fail("the cell is not periodic in all directions (pbc); only periodic ones are read");
    try {
        return PeriodicCell(Eigen::Map<const Mat3>(edges->data()));
    } catch (const InputError& error) {
        lines.fail(error.what());
    }
}

/// The columns of one property: `width` of them.
std::vector<Column> columns_of_property(std::string_view name, std::size_t width) {
    if (name == "pos" && width == 3) return {Column::x, Column::y, Column::z};
    if (name == "velo" && width == 3) return {Column::vx, Column::vy, Column::vz};
    const bool is_known = (name == "id" || name == "radius" || name == "diameter") && width == 1;
    if (is_known) return {column_named(name)};
    return std::vector<Column>(width, Column::ignored);
}

std::vector<Column> columns_of(const LineReader& lines, const Keys& keys) {
    const auto properties = keys.find("Properties");
    if (properties == keys.end()) lines.fail("Properties=... was expected; add it");
    const auto parts = split(properties->second, ':');
    std::vector<Column> columns;
    for (std::size_t k = 0; k + 2 < parts.size(); k += 3) {
        const auto width = parse_integer(parts[k + 2]);
        if (!width || *width < 1 || *width > 1000) break;
        const auto more = columns_of_property(parts[k], static_cast<std::size_t>(*width));
        columns.insert(columns.end(), more.begin(), more.end());
    }
    if (parts.size() % 3 != 0 || columns.empty())
        lines.fail(fmt::format("Properties={} must be made of name:type:count; correct it",
                               properties->second));
    return columns;
}

struct XyzFrame {
    Count spheres = 0;
    LineReader::Place comment;  ///< the line before the first sphere
};

/// Reads the line with the number of spheres; nothing at the end of the file.
std::optional<XyzFrame> next_frame(LineReader& lines) {
    do
        if (!lines.next()) return std::nullopt;
    while (split(lines.line()).empty());
    const Count spheres = sphere_count_of(lines, lines.line());
    return XyzFrame{spheres, lines.place()};
}

XyzFrame find_last_frame(LineReader& lines) {
    std::optional<XyzFrame> found;
    while (const std::optional<XyzFrame> frame = next_frame(lines)) {
        found = frame;
        for (Count row = -1; row < found->spheres; ++row)
            if (!lines.next())
                lines.fail(fmt::format("the last frame ends after {} of {} spheres; write it again",
                                       std::max<Count>(row, 0), found->spheres));
    }
    if (!found) lines.fail("the file is empty; the number of spheres was expected");
    return *found;
}

}  // namespace

Packing read_extended_xyz(const std::filesystem::path& path) {
    LineReader lines(path);
    const XyzFrame frame = find_last_frame(lines);
    lines.go_to(frame.comment);
    lines.next();
    const Keys keys = keys_of(lines.line());
    ParticleRows rows(lines, columns_of(lines, keys));
    Packing packing;
    packing.cell = cell_of(lines, keys);
    packing.time = numbers_in<1>(keys, "Time").value_or(std::array{0.0})[0];
    if (const auto step = keys.find("Step"); step != keys.end())
        packing.step = parse_integer(step->second).value_or(0);
    for (Count row = 0; row < frame.spheres; ++row) {
        lines.next();
        rows.add(lines, packing);
    }
    rows.finish(lines, packing);
    if (const auto origin = numbers_in<3>(keys, "Origin"))
        for (Vec3& position : packing.positions) position -= Vec3(origin->data());
    return packing;
}

void write_extended_xyz(const Packing& packing, const std::filesystem::path& path) {
    check_packing(packing);
    const Mat3& h = packing.cell.matrix();
    const bool moving = !packing.velocities.empty();
    write_whole_file(path, [&](FileSink& sink) {
        fmt::memory_buffer text;
        const auto out = std::back_inserter(text);
        fmt::format_to(out, "{}\nLattice=\"{}\" ", packing.size(),
                       fmt::join(h.data(), h.data() + 9, " "));
        fmt::format_to(out, "Properties=species:S:1:pos:R:3:radius:R:1:id:I:1{} ",
                       moving ? ":velo:R:3" : "");
        fmt::format_to(out, "pbc=\"T T T\" Time={} Step={}\n", packing.time, packing.step);
        for (std::size_t i = 0; i < packing.positions.size(); ++i) {
            const Vec3& x = packing.positions[i];
            fmt::format_to(out, FMT_COMPILE("X {} {} {} {} {}"), x[0], x[1], x[2],
                           0.5 * packing.diameters[i], packing.ids[i]);
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
