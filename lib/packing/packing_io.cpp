// SPDX-License-Identifier: BSD-3-Clause
#include "packing/packing_io.h"

#include "core/check.h"
#include "packing/csv.h"
#include "packing/extended_xyz.h"
#include "packing/lammps_data.h"
#include "packing/lammps_dump.h"
#include "packing/packing_file.h"
#include "packing/particle_rows.h"

#include <array>
#include <fstream>
#include <vector>

namespace jam {

namespace fs = std::filesystem;

namespace {

/// How to read and write a format, and what it can hold besides cell, ids, diameters, positions and
/// velocities, which they all hold.
struct Format {
    std::string_view extension;
    std::string_view name;
    Packing (*read)(const fs::path&);
    void (*write)(const Packing&, const fs::path&);
    bool holds_step;
    bool holds_time;
    bool holds_density;
    bool is_for_lammps;  ///< ids from 1
    bool holds_all = false;
};

Packing read_last_frame(const fs::path& path) {
    return read_lammps_dump(path);
}

void write_with_one_density(const Packing& packing, const fs::path& path) {
    write_lammps_data(packing, path);
}

void save_without_extras(const Packing& packing, const fs::path& path) {
    save_packing(packing, path);
}

constexpr std::array<Format, 5> formats = {{
    {".h5", "a packing file", load_packing, save_without_extras, true, true, true, false, true},
    {".dump", "a LAMMPS dump", read_last_frame, write_lammps_dump, true, false, false, true},
    {".data", "a LAMMPS data file", read_lammps_data, write_with_one_density, false, false, true,
     true},
    {".xyz", "an extended XYZ file", read_extended_xyz, write_extended_xyz, true, true, false,
     false},
    {".csv", "a CSV file", read_csv, write_csv, false, false, false, false},
}};

const Format* format_by_name(const fs::path& path) {
    for (const Format& format : formats)
        if (path.extension() == format.extension) return &format;
    return nullptr;
}

const Format* format_by_content(const fs::path& path) {
    std::array<char, 8> first{};
    std::ifstream(path, std::ios::binary).read(first.data(), first.size());
    const std::string_view bytes(first.data(), first.size());
    if (bytes == "\x89HDF\r\n\x1a\n") return &formats[0];
    return bytes.starts_with("ITEM: ") ? &formats[1] : nullptr;
}

const Format& need_format(const fs::path& path, const Format* format) {
    require(format != nullptr,
            "{}: the end of its name says no format; it must be .h5, .dump, .data, .xyz or .csv",
            path.string());
    return *format;
}

bool is_default(const Material& material) {
    const Material usual;
    return material.law == usual.law && material.stiffness == usual.stiffness &&
           material.damping == usual.damping;
}

bool is_empty(const Provenance& provenance) {
    return provenance.creator.empty() && provenance.command_line.empty() &&
           provenance.scene.empty() && provenance.verdict.empty() && provenance.seed == 0;
}

std::vector<std::string> losses(const Packing& packing, const Format& format) {
    std::vector<std::string> lost;
    const auto note = [&](bool is_lost, std::string_view what) {
        if (is_lost && !format.holds_all) lost.emplace_back(what);
    };
    note(!format.holds_step && packing.step != 0, "the step");
    note(!format.holds_time && packing.time != 0.0, "the time");
    note(!is_default(packing.material), "the contact law with its stiffness and damping");
    note(!format.holds_density && packing.material.density != Material{}.density, "the density");
    note(!packing.applied_pressure.isZero(0.0), "the applied pressure");
    note(!is_empty(packing.provenance), "the scene, command line, seed and verdict");
    const std::int64_t shift = format.is_for_lammps ? shift_to_positive(packing) : 0;
    note(shift != 0, fmt::format("the ids as they are ({} is added to each)", shift));
    note(format.extension == ".data" && !packing.cell.is_reduced(),
         "the edges of the cell as they are (reduced ones of the same lattice are written)");
    return lost;
}

}  // namespace

Packing read_packing(const fs::path& path) {
    require(!fs::is_directory(path), "{}: is a folder; give the name of a file in it",
            path.string());
    const Format* format = format_by_name(path);
    return need_format(path, format != nullptr ? format : format_by_content(path)).read(path);
}

void write_packing(const Packing& packing, const fs::path& path) {
    need_format(path, format_by_name(path)).write(packing, path);
}

std::string what_is_lost(const Packing& packing, const fs::path& path) {
    const Format& format = need_format(path, format_by_name(path));
    const std::vector<std::string> lost = losses(packing, format);
    if (lost.empty()) return "";
    return fmt::format("{}: {} does not hold {}.", path.string(), format.name,
                       fmt::join(lost, ", "));
}

}  // namespace jam
