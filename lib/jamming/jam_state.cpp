// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/jam_state.h"

#include "analysis/contact_network.h"
#include "core/check.h"
#include "packing/packing_io.h"
#include "placement/random_start.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace jam {

namespace {

Particles particles_at(const std::vector<Vec3>& centers, const std::vector<double>& diameters,
                       const Scene& scene) {
    const std::size_t count = diameters.size();
    Particles particles;
    particles.spheres.resize(count);
    particles.motions.resize(count);
    particles.loads.assign(count, Load{Vec3::Zero(), 0.0});
    particles.ids.resize(count);
    std::iota(particles.ids.begin(), particles.ids.end(), 0u);
    for (std::size_t i = 0; i < count; ++i) {
        particles.spheres[i] = {centers[i], diameters[i]};
        particles.motions[i].velocity.setZero();
    }
    set_masses(particles, scene.protocol.masses, scene.contact.density);
    return particles;
}

/// What no step can begin from: a sphere that reaches itself through the cell, and two spheres of
/// which no direction leads apart.
void require_usable(const Packing& packing, const std::filesystem::path& file) {
    const double width = packing.cell.perpendicular_widths().minCoeff();
    const double largest = *std::ranges::max_element(packing.diameters);
    require(width > largest,
            "start.packing = {}: its cell is {:.6g} wide, and its largest sphere {:.6g}; a cell "
            "must be wider than its spheres: use a packing of more particles",
            file.string(), width, largest);
    try {
        find_contacts(packing);
    } catch (const InputError& reason) {
        throw InputError(fmt::format("start.packing = {}: {}", file.string(), reason.what()));
    }
}

JamState state_of_packing(const Scene& scene) {
    Packing packing = read_packing(scene.start.packing);
    packing.cell = packing.cell.reduced().cell;
    require_usable(packing, scene.start.packing);
    JamState state;
    state.cell = packing.cell;
    std::vector<Vec3> centers;
    centers.reserve(packing.positions.size());
    for (const Vec3& position : packing.positions)
        centers.push_back(wrapped(state.cell.fractional(position)));
    state.particles = particles_at(centers, packing.diameters, scene);
    state.original_ids = packing.ids;
    return state;
}

}  // namespace

double inertial_mass(double diameter, double smallest_diameter, Masses masses, double density) {
    switch (masses) {
        case Masses::true_mass:
            return density * sphere_volume(diameter);
        case Masses::diameter:
            return density * sphere_volume(smallest_diameter) * diameter / smallest_diameter;
        case Masses::equal:
            return density * sphere_volume(smallest_diameter);
    }
    return 0.0;
}

double unit_of_time(const Material& material, double smallest_diameter) {
    return std::sqrt(material.density * sphere_volume(smallest_diameter) / material.stiffness);
}

void set_masses(Particles& particles, Masses masses, double density) {
    const double smallest =
        std::ranges::min_element(particles.spheres, {}, &Sphere::diameter)->diameter;
    for (std::size_t i = 0; i < particles.motions.size(); ++i)
        particles.motions[i].mass =
            inertial_mass(particles.spheres[i].diameter, smallest, masses, density);
}

JamState start_state(const Scene& scene) {
    if (!scene.start.packing.empty()) return state_of_packing(scene);
    const std::vector<double> diameters = draw_diameters(scene);
    const RandomStart start = place_at_random(
        diameters, {.volume_fraction = scene.start.volume_fraction, .seed = scene.run.seed});
    JamState state;
    state.cell = start.cell;
    state.particles = particles_at(start.centers, diameters, scene);
    return state;
}

std::vector<double> diameters_by_id(const Particles& particles) {
    std::vector<double> diameters(particles.spheres.size());
    for (std::size_t i = 0; i < diameters.size(); ++i)
        diameters[particles.ids[i]] = particles.spheres[i].diameter;
    return diameters;
}

Packing to_packing(const JamState& state, const Scene& scene) {
    const Particles& particles = state.particles;
    const auto count = static_cast<std::size_t>(particles.size());
    const bool relaxing = state.quasistatic.stage == QuasistaticState::Stage::relaxation;
    Packing packing;
    packing.cell = state.cell;
    packing.positions.resize(count);
    packing.diameters.resize(count);
    packing.velocities.resize(count);
    packing.ids = state.original_ids;
    if (packing.ids.empty()) {
        packing.ids.resize(count);
        std::iota(packing.ids.begin(), packing.ids.end(), std::int64_t{0});
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto to = static_cast<std::size_t>(particles.ids[i]);
        packing.positions[to] = state.cell.cartesian(wrapped(particles.spheres[i].center));
        packing.diameters[to] = particles.spheres[i].diameter;
        // The velocities of a relaxation are no motion in time.
        packing.velocities[to] = relaxing ? Vec3(Vec3::Zero()) : particles.motions[i].velocity;
    }
    packing.material = scene.contact;
    packing.step = state.step;
    packing.time = state.time;
    packing.applied_pressure = scene.protocol.pressure;
    packing.provenance.seed = scene.run.seed;
    return packing;
}

}  // namespace jam
