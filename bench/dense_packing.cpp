// SPDX-License-Identifier: BSD-3-Clause
#include "dense_packing.h"

#include "jamming/nph_step.h"
#include "packing/packing_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace jam::bench {

namespace {

void compress(JamState& state, const Scene& scene) {
    const NphSettings settings = nph_settings(scene, state);
    NphScratch scratch(diameters_by_id(state.particles), {});
    begin_nph(state, settings, scratch);
    double before = state.cell.volume();
    for (;;) {
        for (int step = 0; step < 500; ++step) nph_step(state, settings, scratch);
        const double now = state.cell.volume();
        if (state.step >= 2000 && now > 0.999 * before) return;
        before = now;
    }
}

SizeDistribution distribution_of(const DensePacking& wanted) {
    if (wanted.size_ratio <= 1.0) return Monodisperse{};
    if (wanted.small_fraction <= 0.0) return PowerLaw{wanted.size_ratio, wanted.alpha};
    const double small_for_each_large =
        wanted.small_fraction / (1.0 - wanted.small_fraction) * std::pow(wanted.size_ratio, 3);
    const auto large = static_cast<double>(wanted.count) / (1.0 + small_for_each_large);
    return Binary{wanted.size_ratio, wanted.small_fraction,
                  std::max<Count>(1, std::llround(large))};
}

JamState made_or_kept(const std::string& name, Scene scene) {
    const std::filesystem::path folder = "build/bench_packings";
    const std::filesystem::path file = folder / (name + ".h5");
    if (!std::filesystem::exists(file)) {
        JamState state = start_state(scene);
        compress(state, scene);
        std::filesystem::create_directories(folder);
        save_packing(to_packing(state, scene), file);
    }
    scene.start.packing = file;
    return start_state(scene);
}

/// Calls use(shift) for the corners of `along`^3 cells.
template <typename Use>
void for_each_copy(int along, Use&& use) {
    for (int z = 0; z < along; ++z)
        for (int y = 0; y < along; ++y)
            for (int x = 0; x < along; ++x) use(Vec3(x, y, z));
}

void append(Particles& particles, const Sphere& sphere, const Motion& motion) {
    particles.ids.push_back(static_cast<std::uint32_t>(particles.spheres.size()));
    particles.spheres.push_back(sphere);
    particles.motions.push_back(motion);
    particles.loads.push_back({Vec3::Zero(), 0.0});
}

void reserve(Particles& particles, std::size_t count) {
    particles.ids.reserve(count);
    particles.spheres.reserve(count);
    particles.motions.reserve(count);
    particles.loads.reserve(count);
}

std::size_t cube(int along) {
    return static_cast<std::size_t>(along) * static_cast<std::size_t>(along) *
           static_cast<std::size_t>(along);
}

JamState replicated(const JamState& one, int along) {
    JamState state;
    reserve(state.particles, cube(along) * one.particles.spheres.size());
    state.cell = PeriodicCell(Mat3(one.cell.matrix() * along));
    for_each_copy(along, [&](const Vec3& shift) {
        for (std::size_t i = 0; i < one.particles.spheres.size(); ++i) {
            const Sphere& sphere = one.particles.spheres[i];
            append(state.particles, {(sphere.center + shift) / along, sphere.diameter},
                   one.particles.motions[i]);
        }
    });
    return state;
}

/// Whether a sphere of diameter 1 would reach deeper into the nearest large sphere of the lattice
/// than a contact does. Places in units of the lattice.
bool is_cut(const Vec3& place, double lattice, double size_ratio) {
    const Vec3 from_center = lattice * (place.array() - place.array().floor() - 0.5).matrix();
    constexpr double usual_overlap = 2e-3;
    return from_center.norm() < 0.5 * (size_ratio + 1.0) - usual_overlap;
}

}  // namespace

Scene bench_scene(const DensePacking& wanted) {
    Scene scene;
    scene.sizes.distribution = distribution_of(wanted);
    if (!std::holds_alternative<Binary>(scene.sizes.distribution)) scene.sizes.count = wanted.count;
    scene.protocol.pressure = Mat3::Identity() * 1e-3;
    scene.protocol.masses = Masses::diameter;
    return scene;
}

JamState dense_packing(const DensePacking& wanted) {
    const std::string kind = wanted.small_fraction > 0.0
                                 ? fmt::format("small{}", wanted.small_fraction)
                                 : fmt::format("alpha{}", wanted.alpha);
    const JamState state = made_or_kept(
        fmt::format("lambda{}_{}_n{}", wanted.size_ratio, kind, wanted.count), bench_scene(wanted));
    return wanted.replicas == 1 ? state : replicated(state, wanted.replicas);
}

JamState dense_matrix(double size_ratio, int large_along) {
    constexpr double matrix_fraction = 0.645;  // of a monodisperse packing at p = 1e-3
    const double large_volume = std::numbers::pi / 6.0 * std::pow(size_ratio, 3);
    const double lattice = std::cbrt(large_volume * (1.0 + 1.0 / matrix_fraction));
    const double edge = large_along * lattice;
    const int along = std::max(1, static_cast<int>(std::lround(edge / 15.0)));
    DensePacking matrix;
    matrix.count =
        std::llround(matrix_fraction * std::pow(edge / along, 3) / (std::numbers::pi / 6.0));
    Scene scene = bench_scene(matrix);
    scene.protocol.free_cell = FreeCell::isotropic;
    const JamState small = made_or_kept(fmt::format("cube_n{}", matrix.count), scene);

    JamState state;
    state.cell = PeriodicCell(Mat3(small.cell.matrix() * along));
    const double true_lattice = state.cell.matrix()(0, 0) / large_along;
    reserve(state.particles, cube(along) * small.particles.spheres.size() + cube(large_along));
    const Motion at_rest{Vec3::Zero(), small.particles.motions.front().mass};
    const Motion at_rest_large{Vec3::Zero(), at_rest.mass * size_ratio};
    for_each_copy(along, [&](const Vec3& shift) {
        for (const Sphere& sphere : small.particles.spheres) {
            const Vec3 center = (sphere.center + shift) / along;
            if (!is_cut(center * large_along, true_lattice, size_ratio))
                append(state.particles, {center, 1.0}, at_rest);
        }
    });
    for_each_copy(large_along, [&](const Vec3& corner) {
        append(state.particles, {(corner + Vec3::Constant(0.5)) / large_along, size_ratio},
               at_rest_large);
    });
    return state;
}

}  // namespace jam::bench
