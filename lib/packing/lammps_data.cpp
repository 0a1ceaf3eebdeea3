// SPDX-License-Identifier: BSD-3-Clause
#include "packing/lammps_data.h"

#include "core/check.h"
#include "core/parallel.h"
#include "core/whole_file.h"
#include "packing/line_reader.h"
#include "packing/particle_rows.h"

#include <fmt/compile.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

namespace jam {

namespace {

std::string_view without_comment(std::string_view line) {
    return line.substr(0, line.find('#'));
}

std::vector<std::string_view> words_of(const LineReader& lines) {
    return split(without_comment(lines.line()));
}

/// Section titles are the only lines that begin with a letter.
bool is_title(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t");
    return begin != std::string_view::npos &&
           std::isalpha(static_cast<unsigned char>(line[begin])) != 0;
}

/// Goes to the next line with words on it; false at the end of the file.
bool next_with_words(LineReader& lines) {
    while (lines.next())
        if (!words_of(lines).empty()) return true;
    return false;
}

struct Header {
    Count spheres = 0;
    std::array<double, 3> low{}, high{}, tilt{};
};

double number_in(const LineReader& lines, std::string_view word) {
    const auto number = parse_number(word);
    if (!number) lines.fail(fmt::format("'{}' is not a finite number; correct it", word));
    return *number;
}

/// Reads one line of the header; those about bonds, types and such say nothing of a packing.
void read_header_line(const LineReader& lines, Header& header) {
    const auto words = words_of(lines);
    const auto ends_with = [&](std::size_t numbers, std::initializer_list<std::string_view> rest) {
        return words.size() == numbers + rest.size() &&
               std::equal(rest.begin(), rest.end(), words.end() - std::ssize(rest));
    };
    if (ends_with(1, {"atoms"})) header.spheres = sphere_count_of(lines, words[0]);
    constexpr std::array<std::array<std::string_view, 2>, 3> bounds = {
        {{"xlo", "xhi"}, {"ylo", "yhi"}, {"zlo", "zhi"}}};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!ends_with(2, {bounds[k][0], bounds[k][1]})) continue;
        header.low[k] = number_in(lines, words[0]);
        header.high[k] = number_in(lines, words[1]);
    }
    if (ends_with(3, {"xy", "xz", "yz"}))
        for (std::size_t k = 0; k < 3; ++k) header.tilt[k] = number_in(lines, words[k]);
    if (ends_with(3, {"avec"}))
        lines.fail("the box is general triclinic; write the file with triclinic/general no");
}

PeriodicCell cell_of(const LineReader& lines, const Header& header) {
    const auto [xy, xz, yz] = header.tilt;
    Mat3 h;
    h << header.high[0] - header.low[0], xy, xz,  //
        0.0, header.high[1] - header.low[1], yz,  //
        0.0, 0.0, header.high[2] - header.low[2];
    if (h.diagonal().minCoeff() <= 0.0)
        lines.fail(
            "the lines with xlo xhi, ylo yhi and zlo zhi must come before, each with its "
            "upper bound above its lower one; correct them");
    return PeriodicCell(h);
}

void check_style(const LineReader& lines) {
    const std::size_t mark = lines.line().find('#');
    if (mark == std::string_view::npos) return;
    const auto style = split(lines.line().substr(mark + 1));
    if (!style.empty() && style[0] != "sphere")
        lines.fail(
            fmt::format("the atom style is '{}', which has no diameters; write the file "
                        "with atom_style sphere",
                        style[0]));
}

ParticleRows atom_rows(const LineReader& lines) {
    std::vector<Column> columns = {Column::id, Column::ignored, Column::diameter, Column::density,
                                   Column::x,  Column::y,       Column::z};
    const bool has_images = words_of(lines).size() == columns.size() + 3;
    if (has_images) columns.insert(columns.end(), 3, Column::ignored);
    return {lines, std::move(columns)};
}

void need_row(LineReader& lines, Count row, Count count) {
    const bool found = row == 0 ? next_with_words(lines) : lines.next();
    if (!found || words_of(lines).empty() || is_title(lines.line()))
        lines.fail(fmt::format("the section ends after {} of {} lines; every sphere needs one", row,
                               count));
}

void read_atoms(LineReader& lines, const Header& header, Packing& packing) {
    check_style(lines);
    packing.cell = cell_of(lines, header);
    if (header.spheres == 0)
        lines.fail("a line with the number of atoms must come before ('1000 atoms'); add it");
    need_row(lines, 0, header.spheres);
    ParticleRows rows = atom_rows(lines);
    rows.add(lines, packing);
    for (Count row = 1; row < header.spheres; ++row) {
        need_row(lines, row, header.spheres);
        rows.add(lines, packing);
    }
    rows.finish(lines, packing);
    packing.material.density = *rows.density();
    const Vec3 origin(header.low[0], header.low[1], header.low[2]);
    for (Vec3& position : packing.positions) position -= origin;
}

using PlaceById = std::vector<std::pair<std::int64_t, std::size_t>>;

PlaceById places_by_id(const Packing& packing) {
    PlaceById places(packing.ids.size());
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = {packing.ids[i], i};
    sort_total_order(places, std::less<>());
    return places;
}

/// Lines of id vx vy vz, and for spheres wx wy wz, in any order.
void read_velocities(LineReader& lines, Packing& packing) {
    if (packing.positions.empty()) lines.fail("the section Atoms must come before; move it up");
    const PlaceById places = places_by_id(packing);
    packing.velocities.assign(packing.positions.size(), Vec3::Zero());
    std::vector<bool> given(packing.positions.size());
    for (Count row = 0; row < packing.size(); ++row) {
        need_row(lines, row, packing.size());
        const auto words = words_of(lines);
        if (words.size() < 4) lines.fail("id, vx, vy and vz were expected; give all four");
        const auto id = parse_integer(words[0]);
        const auto found = std::lower_bound(places.begin(), places.end(),
                                            std::pair(id.value_or(0), std::size_t{0}));
        if (!id || found == places.end() || found->first != *id || given[found->second])
            lines.fail(
                fmt::format("id '{}' is not that of a sphere without a velocity; every "
                            "sphere of the section Atoms needs one line",
                            words[0]));
        given[found->second] = true;
        Vec3& velocity = packing.velocities[found->second];
        for (int k = 0; k < 3; ++k)
            velocity[k] = number_in(lines, words[static_cast<std::size_t>(k) + 1]);
    }
}

}  // namespace

Packing read_lammps_data(const std::filesystem::path& path) {
    LineReader lines(path);
    if (!lines.next()) lines.fail("the file is empty; give a LAMMPS data file");
    Header header;
    Packing packing;
    bool in_header = true;
    bool needs_title = false;
    while (next_with_words(lines)) {
        const bool title = is_title(lines.line());
        if (needs_title && !title)
            lines.fail("the section has more lines than there are atoms; correct their number");
        if (title) in_header = false;
        if (in_header) read_header_line(lines, header);
        const std::string section(words_of(lines)[0]);
        if (section == "Atoms") read_atoms(lines, header, packing);
        if (section == "Velocities") read_velocities(lines, packing);
        needs_title = section == "Atoms" || section == "Velocities";
    }
    if (packing.positions.empty())
        lines.fail("there is no section Atoms; give a LAMMPS data file of atom_style sphere");
    return packing;
}

void write_lammps_data(const Packing& packing, const std::filesystem::path& path,
                       std::span<const double> densities) {
    check_packing(packing);
    require(densities.empty() || densities.size() == packing.positions.size(),
            "packing: {} spheres, {} densities; give one a sphere or none at all", packing.size(),
            densities.size());
    const PeriodicCell cell =
        packing.cell.is_reduced() ? packing.cell : packing.cell.reduced().cell;
    const Mat3& h = cell.matrix();
    const std::int64_t shift = shift_to_positive(packing);
    write_whole_file(path, [&](FileSink& sink) {
        fmt::memory_buffer text;
        const auto out = std::back_inserter(text);
        const auto pass_on = [&] {
            sink.write({text.data(), text.size()});
            text.clear();
        };
        fmt::format_to(out, "Packing of spheres, step {}\n\n{} atoms\n1 atom types\n\n",
                       packing.step, packing.size());
        fmt::format_to(out, "0 {} xlo xhi\n0 {} ylo yhi\n0 {} zlo zhi\n", h(0, 0), h(1, 1),
                       h(2, 2));
        if (!cell.is_orthogonal())
            fmt::format_to(out, "{} {} {} xy xz yz\n", h(0, 1), h(0, 2), h(1, 2));
        fmt::format_to(out, "\nAtoms # sphere\n\n");
        for (std::size_t i = 0; i < packing.positions.size(); ++i) {
            const Vec3& x = packing.positions[i];
            const double density = densities.empty() ? packing.material.density : densities[i];
            fmt::format_to(out, FMT_COMPILE("{} 1 {} {} {} {} {}\n"), packing.ids[i] + shift,
                           packing.diameters[i], density, x[0], x[1], x[2]);
            pass_on();
        }
        if (packing.velocities.empty()) return;
        fmt::format_to(out, "\nVelocities\n\n");
        for (std::size_t i = 0; i < packing.velocities.size(); ++i) {
            const Vec3& v = packing.velocities[i];
            fmt::format_to(out, FMT_COMPILE("{} {} {} {} 0 0 0\n"), packing.ids[i] + shift, v[0],
                           v[1], v[2]);
            pass_on();
        }
    });
}

}  // namespace jam
