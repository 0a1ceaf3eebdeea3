// SPDX-License-Identifier: BSD-3-Clause
#include "packing/packing_file.h"

#include "core/check.h"
#include "core/particle_limit.h"
#include "core/version.h"
#include "packing/hdf5_handles.h"
#include "particles/particles.h"

#include <numeric>

namespace jam {

namespace {

using hdf5::Group;

/// As arrays of the file see them: row by row, where Eigen's default is by columns.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

static_assert(sizeof(Vec3) == 3 * sizeof(double));

std::span<const double> components(const std::vector<Vec3>& vectors) {
    return {vectors.data()->data(), 3 * vectors.size()};
}
std::span<double> components(std::vector<Vec3>& vectors) {
    return {vectors.data()->data(), 3 * vectors.size()};
}

void write_tensor(const Group& group, std::string_view name, const Mat3& tensor,
                  const hdf5::Shape& shape) {
    const RowMajor rows = tensor;
    group.write(name, std::span<const double>(rows.data(), 9), shape);
}

Mat3 read_tensor(const Group& group, std::string_view name, const hdf5::Shape& shape) {
    RowMajor rows;
    group.read(name, std::span<double>(rows.data(), 9), shape);
    return rows;
}

void write_h5md(const Group& root, const Provenance& provenance) {
    const Group h5md = root.create("h5md");
    constexpr std::array<std::int32_t, 2> format = {1, 1};
    h5md.write_attribute("version", std::span<const std::int32_t>(format), {2});
    h5md.create("author").write_attribute("name", "unknown");
    const Group creator = h5md.create("creator");
    creator.write_attribute("name", provenance.creator.empty() ? "widejam" : provenance.creator);
    creator.write_attribute("version", version);
}

/// H5MD's time-dependent element with one frame; all share the step and time of the positions.
Group write_frame(const Group& parent, std::string_view name) {
    Group element = parent.create(name);
    element.link("step", "/particles/all/position/step");
    element.link("time", "/particles/all/position/time");
    return element;
}

std::vector<double> true_masses(const Packing& packing) {
    std::vector<double> masses(packing.diameters.size());
    for (std::size_t i = 0; i < masses.size(); ++i)
        masses[i] = packing.material.density * sphere_volume(packing.diameters[i]);
    return masses;
}

void write_box(const Group& all, const PeriodicCell& cell) {
    const Group box = all.create("box");
    constexpr std::array<std::int32_t, 1> dimension = {3};
    constexpr std::array<std::string_view, 3> boundary = {"periodic", "periodic", "periodic"};
    box.write_attribute("dimension", std::span<const std::int32_t>(dimension), {});
    box.write_attribute("boundary", boundary);
    const Mat3 edges_as_rows = cell.matrix().transpose();
    write_tensor(write_frame(box, "edges"), "value", edges_as_rows, {1, 3, 3});
}

void write_particles(const Group& root, const Packing& packing) {
    const Group all = root.create("particles").create("all");
    const std::uint64_t size = packing.positions.size();
    const Group position = all.create("position");
    position.write("step", std::vector<std::int64_t>{packing.step});
    position.write("time", std::vector<double>{packing.time});
    position.write("value", components(packing.positions), {1, size, 3});
    write_box(all, packing.cell);
    if (!packing.velocities.empty())
        write_frame(all, "velocity").write("value", components(packing.velocities), {1, size, 3});
    all.write("diameter", packing.diameters);
    all.write("mass", true_masses(packing));
    all.write("id", packing.ids);
}

void write_parameters(const Group& root, const Packing& packing) {
    const Group parameters = root.create("parameters");
    parameters.write_text("creator", packing.provenance.creator);
    parameters.write_text("command_line", packing.provenance.command_line);
    parameters.write_text("scene", packing.provenance.scene);
    parameters.write_text("verdict", packing.provenance.verdict);
    parameters.write("seed", packing.provenance.seed);
    write_tensor(parameters, "applied_pressure", packing.applied_pressure, {3, 3});
    const Group material = parameters.create("material");
    material.write_text("law", packing.material.law == ContactLaw::hooke ? "hooke" : "hertz");
    material.write("stiffness", packing.material.stiffness);
    material.write("damping", packing.material.damping);
    material.write("density", packing.material.density);
}

void write_observables(const Group& root, const PackingExtras& extras) {
    const Group observables = root.create("observables");
    for (const auto& [name, number] : extras.numbers)
        write_frame(observables, name).write("value", std::vector<double>{number});
    for (const auto& [name, tensor] : extras.tensors)
        write_tensor(write_frame(observables, name), "value", tensor, {1, 3, 3});
}

/// H5MD's tuples name particles by id.
void write_contacts(const Group& root, const Packing& packing,
                    std::span<const std::array<Index, 2>> contacts) {
    std::vector<std::int64_t> ids;
    ids.reserve(2 * contacts.size());
    for (const auto& pair : contacts)
        for (const Index place : pair)
            ids.push_back(packing.ids.at(static_cast<std::size_t>(place)));
    const Group connectivity = root.create("connectivity");
    connectivity.write("contacts", std::span<const std::int64_t>(ids), {contacts.size(), 2});
    connectivity.refer("contacts", "particles_group", "/particles/all");
}

/// All spheres as one poly-vertex cell, which costs the file less than a vertex each.
void write_vtkhdf(const Group& root, const Packing& packing) {
    const Group vtk = root.create("VTKHDF");
    constexpr std::array<std::int64_t, 2> format = {1, 0};
    vtk.write_attribute("Version", std::span<const std::int64_t>(format), {2});
    vtk.write_attribute("Type", "UnstructuredGrid");
    const std::int64_t size = packing.size();
    vtk.write("NumberOfPoints", std::vector<std::int64_t>{size});
    vtk.write("NumberOfCells", std::vector<std::int64_t>{1});
    vtk.write("NumberOfConnectivityIds", std::vector<std::int64_t>{size});
    std::vector<std::int64_t> connectivity(packing.positions.size());
    std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
    vtk.write("Connectivity", connectivity);
    vtk.write("Offsets", std::vector<std::int64_t>{0, size});
    constexpr std::uint8_t poly_vertex = 2;
    vtk.write("Types", std::vector<std::uint8_t>{poly_vertex});
    vtk.show_last_frame("Points", "/particles/all/position/value");
    const Group point_data = vtk.create("PointData");
    point_data.link("diameter", "/particles/all/diameter");
    point_data.link("id", "/particles/all/id");
    vtk.create("CellData");
    vtk.create("FieldData");
}

void require_layout(const Group& root, const std::filesystem::path& path) {
    const bool is_ours = root.has("h5md") && root.has("particles/all/position/value") &&
                         root.has("particles/all/diameter");
    if (!is_ours)
        throw FileError(
            fmt::format("{}: holds no packing (/particles/all with position and "
                        "diameter, in H5MD's layout); give a file that this program "
                        "saved, or convert this one",
                        path.string()));
}

std::uint64_t read_size(const Group& all, const std::filesystem::path& path) {
    const hdf5::Shape shape = all.shape("diameter");
    if (shape.size() != 1 || shape[0] == 0 || std::cmp_greater(shape[0], max_particle_count))
        throw FileError(
            fmt::format("{}: /particles/all/diameter: must be a list of 1 to {} "
                        "diameters; the file is damaged or was made by another program",
                        path.string(), max_particle_count));
    return shape[0];
}

void read_particles(const Group& all, std::uint64_t size, Packing& packing) {
    packing.positions.resize(size);
    packing.diameters.resize(size);
    packing.ids.resize(size);
    all.read("position/value", components(packing.positions), {1, size, 3});
    all.read("diameter", std::span(packing.diameters), {size});
    all.read("id", std::span(packing.ids), {size});
    if (!all.has("velocity")) return;
    packing.velocities.resize(size);
    all.read("velocity/value", components(packing.velocities), {1, size, 3});
}

void read_box(const Group& all, Packing& packing) {
    packing.cell = PeriodicCell(read_tensor(all, "box/edges/value", {1, 3, 3}).transpose());
    all.read("position/step", std::span<std::int64_t>(&packing.step, 1), {1});
    all.read("position/time", std::span<double>(&packing.time, 1), {1});
}

ContactLaw read_law(const Group& material, const std::filesystem::path& path) {
    const std::string law = material.read_text("law");
    if (law != "hooke" && law != "hertz")
        throw FileError(
            fmt::format("{}: /parameters/material/law: '{}' is not a contact law; it "
                        "must be hooke or hertz",
                        path.string(), law));
    return law == "hooke" ? ContactLaw::hooke : ContactLaw::hertz;
}

void read_parameters(const Group& parameters, const std::filesystem::path& path, Packing& packing) {
    packing.provenance.creator = parameters.read_text("creator");
    packing.provenance.command_line = parameters.read_text("command_line");
    packing.provenance.scene = parameters.read_text("scene");
    packing.provenance.verdict = parameters.read_text("verdict");
    packing.provenance.seed = parameters.read<std::uint64_t>("seed");
    packing.applied_pressure = read_tensor(parameters, "applied_pressure", {3, 3});
    const Group material = parameters.open("material");
    packing.material.law = read_law(material, path);
    packing.material.stiffness = material.read<double>("stiffness");
    packing.material.damping = material.read<double>("damping");
    packing.material.density = material.read<double>("density");
}

}  // namespace

void save_packing(const Packing& packing, const std::filesystem::path& path,
                  const PackingExtras& extras) {
    check_packing(packing);
    hdf5::write_file(path, [&](const Group& root) {
        write_h5md(root, packing.provenance);
        write_particles(root, packing);
        write_parameters(root, packing);
        write_observables(root, extras);
        write_contacts(root, packing, extras.contacts);
        write_vtkhdf(root, packing);
    });
}

Packing load_packing(const std::filesystem::path& path) {
    const Group root = hdf5::open_file(path);
    require_layout(root, path);
    const Group all = root.open("particles/all");
    Packing packing;
    read_particles(all, read_size(all, path), packing);
    try {
        read_box(all, packing);
        check_packing(packing);
    } catch (const InputError& error) {
        throw FileError(fmt::format("{}: {}", path.string(), error.what()));
    }
    if (root.has("parameters")) read_parameters(root.open("parameters"), path, packing);
    return packing;
}

}  // namespace jam
