// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/checkpoint_file.h"

#include "core/check.h"
#include "packing/hdf5_handles.h"

#include <cstdint>

namespace jam {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t format_version = 6;

fs::path previous(const fs::path& path) {
    fs::path kept = path;
    kept += ".previous";
    return kept;
}

void write_centers(const hdf5::Group& group, const std::vector<Vec3>& centers) {
    if (centers.empty()) return;
    group.write("centers", std::span(centers.front().data(), 3 * centers.size()),
                {centers.size(), 3});
}

std::vector<Vec3> read_centers(const hdf5::Group& group, std::size_t count) {
    if (!group.has("centers")) return {};
    std::vector<Vec3> centers(count);
    group.read("centers", std::span(centers.front().data(), 3 * count), {count, 3});
    return centers;
}

/// Records of four doubles as an array [N][4].
template <typename Entry>
void write_entries(const hdf5::Group& group, const char* name, const std::vector<Entry>& entries) {
    static_assert(sizeof(Entry) == 4 * sizeof(double));
    const auto* values = reinterpret_cast<const double*>(entries.data());
    group.write(name, std::span(values, 4 * entries.size()), {entries.size(), 4});
}

template <typename Entry>
std::vector<Entry> read_entries(const hdf5::Group& group, const char* name, std::size_t count) {
    std::vector<Entry> entries(count);
    auto* values = reinterpret_cast<double*>(entries.data());
    group.read(name, std::span(values, 4 * count), {count, 4});
    return entries;
}

void write_matrix(const hdf5::Group& group, const char* name, const Mat3& matrix) {
    group.write(name, std::span(matrix.data(), 9), {3, 3});
}

Mat3 read_matrix(const hdf5::Group& group, const char* name) {
    Mat3 matrix;
    group.read(name, std::span(matrix.data(), 9), {3, 3});
    return matrix;
}

void write_reference(const hdf5::Group& group, const ListReference& reference) {
    if (reference.centers.empty()) return;
    const hdf5::Group list = group.create("list_reference");
    write_matrix(list, "cell", reference.cell.matrix());
    list.write("strain_margin", reference.reach.strain_margin);
    list.write("skin", reference.reach.skin);
    write_centers(list, reference.centers);
}

ListReference read_reference(const hdf5::Group& group, std::size_t count) {
    ListReference reference;
    if (!group.has("list_reference")) return reference;
    const hdf5::Group list = group.open("list_reference");
    reference.cell = PeriodicCell(read_matrix(list, "cell"));
    reference.reach = {list.read<double>("strain_margin"), list.read<double>("skin")};
    reference.centers = read_centers(list, count);
    return reference;
}

void write_samples(const hdf5::Group& group, const std::deque<Sample>& samples) {
    std::vector<std::int64_t> steps;
    std::vector<double> values;
    for (const Sample& sample : samples) {
        steps.push_back(sample.step);
        values.push_back(sample.volume_fraction);
        values.push_back(sample.coordination);
    }
    group.write("sample_steps", steps);
    group.write("sample_values", values);
}

std::deque<Sample> read_samples(const hdf5::Group& group) {
    const auto steps = group.read_array<std::int64_t>("sample_steps");
    const auto values = group.read_array<double>("sample_values");
    std::deque<Sample> samples;
    for (std::size_t k = 0; k < steps.size() && 2 * k + 1 < values.size(); ++k)
        samples.push_back({steps[k], values[2 * k], values[2 * k + 1]});
    return samples;
}

void write_relaxation(const hdf5::Group& group, const RelaxState& relax) {
    const hdf5::Group to = group.create("relaxation");
    to.write("renewal_age", std::int64_t{relax.renewal_age});
    const ContactStiffness& stiffness = relax.stiffness;
    to.write("stiffness_typical", stiffness.typical);
    write_matrix(to, "stiffness_cell", stiffness.cell);
    std::vector<double> contacts;
    std::vector<SymmetricBlock> blocks;
    for (const ParticleStiffness& particle : stiffness.particles) {
        contacts.push_back(particle.contacts);
        blocks.push_back(particle.block);
    }
    to.write("stiffness_contacts", contacts);
    if (blocks.empty()) return;
    to.write("stiffness_blocks", std::span<const double>(&blocks.front().xx, 6 * blocks.size()),
             {blocks.size(), 6});
}

RelaxState read_relaxation(const hdf5::Group& group) {
    const hdf5::Group from = group.open("relaxation");
    RelaxState relax;
    relax.renewal_age = static_cast<int>(from.read<std::int64_t>("renewal_age"));
    ContactStiffness& stiffness = relax.stiffness;
    stiffness.typical = from.read<double>("stiffness_typical");
    stiffness.cell = read_matrix(from, "stiffness_cell");
    const auto contacts = from.read_array<double>("stiffness_contacts");
    if (!from.has("stiffness_blocks")) return relax;
    std::vector<SymmetricBlock> blocks(contacts.size());
    from.read("stiffness_blocks", std::span(&blocks.front().xx, 6 * blocks.size()),
              {blocks.size(), 6});
    for (std::size_t id = 0; id < blocks.size(); ++id)
        stiffness.particles.push_back({blocks[id], contacts[id]});
    return relax;
}

void write_quasistatic(const hdf5::Group& group, const QuasistaticState& quasistatic) {
    const hdf5::Group to = group.create("quasistatic");
    to.write("stage", static_cast<std::int64_t>(quasistatic.stage));
    to.write("pressure", quasistatic.pressure);
    to.write("lowest_pressure", quasistatic.lowest_pressure);
    to.write("foot_begin", std::int64_t{quasistatic.foot_begin});
    to.write("next_trial", std::int64_t{quasistatic.next_trial});
    to.write("trial_cundall", quasistatic.trial_cundall);
    to.write("last_whole", std::int64_t{quasistatic.last_whole});
    to.write("retreats", std::int64_t{quasistatic.retreats});
    to.write("at_rest", std::int64_t{quasistatic.at_rest});
    const hdf5::Group leap = to.create("leap");
    leap.write("cundall", quasistatic.leap.cundall);
    write_centers(leap, quasistatic.leap.centers);
}

QuasistaticState read_quasistatic(const hdf5::Group& group, std::size_t count) {
    const hdf5::Group from = group.open("quasistatic");
    QuasistaticState quasistatic;
    quasistatic.stage = static_cast<QuasistaticState::Stage>(from.read<std::int64_t>("stage"));
    quasistatic.pressure = from.read<double>("pressure");
    quasistatic.lowest_pressure = from.read<double>("lowest_pressure");
    quasistatic.foot_begin = from.read<std::int64_t>("foot_begin");
    quasistatic.next_trial = from.read<std::int64_t>("next_trial");
    quasistatic.trial_cundall = from.read<double>("trial_cundall");
    quasistatic.last_whole = from.read<std::int64_t>("last_whole");
    quasistatic.retreats = static_cast<int>(from.read<std::int64_t>("retreats"));
    quasistatic.at_rest = from.read<std::int64_t>("at_rest") != 0;
    const hdf5::Group leap = from.open("leap");
    quasistatic.leap = {leap.read<double>("cundall"), read_centers(leap, count)};
    return quasistatic;
}

void write_state(const hdf5::Group& group, const JamState& state) {
    write_matrix(group, "cell", state.cell.matrix());
    write_matrix(group, "velocity_gradient", state.velocity_gradient);
    write_matrix(group, "pressure", state.pressure);
    group.write("step", std::int64_t{state.step});
    group.write("time", state.time);
    group.write("wall_seconds", state.wall_seconds);
    group.write("ids", state.particles.ids);
    write_entries(group, "spheres", state.particles.spheres);
    write_entries(group, "motions", state.particles.motions);
    write_entries(group, "loads", state.particles.loads);
    group.write("original_ids", state.original_ids);
    write_samples(group, state.samples);
    write_reference(group, state.list_reference);
    write_relaxation(group, state.relax);
    write_quasistatic(group, state.quasistatic);
}

JamState read_state(const hdf5::Group& group) {
    JamState state;
    state.cell = PeriodicCell(read_matrix(group, "cell"));
    state.velocity_gradient = read_matrix(group, "velocity_gradient");
    state.pressure = read_matrix(group, "pressure");
    state.step = group.read<std::int64_t>("step");
    state.time = group.read<double>("time");
    state.wall_seconds = group.read<double>("wall_seconds");
    state.particles.ids = group.read_array<std::uint32_t>("ids");
    const std::size_t count = state.particles.ids.size();
    state.particles.spheres = read_entries<Sphere>(group, "spheres", count);
    state.particles.motions = read_entries<Motion>(group, "motions", count);
    state.particles.loads = read_entries<Load>(group, "loads", count);
    state.original_ids = group.read_array<std::int64_t>("original_ids");
    state.samples = read_samples(group);
    state.list_reference = read_reference(group, count);
    state.relax = read_relaxation(group);
    state.quasistatic = read_quasistatic(group, count);
    return state;
}

Checkpoint read_file(const fs::path& path) {
    const hdf5::Group file = hdf5::open_file(path);
    const auto version = file.read<std::int64_t>("format_version");
    if (version != format_version)
        throw FileError(fmt::format(
            "{}: is a checkpoint of format {}, and this program reads format {}; go on with the "
            "version of the program that wrote it, or start from the packing",
            path.string(), version, format_version));
    return {read_state(file), file.read_text("scene")};
}

}  // namespace

void save_checkpoint(const JamState& state, const std::string& scene, const fs::path& path) {
    const fs::path kept = previous(path);
    if (fs::exists(path)) {
        std::error_code ignored;  // without hard links the earlier one is simply not kept
        fs::remove(kept, ignored);
        fs::create_hard_link(path, kept, ignored);
    }
    hdf5::write_file(path, [&](const hdf5::Group& file) {
        file.write("format_version", format_version);
        file.write_text("scene", scene);
        write_state(file, state);
    });
}

Checkpoint load_checkpoint(const fs::path& path) {
    try {
        return read_file(path);
    } catch (const FileError&) {
        if (!fs::exists(previous(path))) throw;
        return read_file(previous(path));
    }
}

}  // namespace jam
