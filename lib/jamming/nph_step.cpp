// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/nph_step.h"

#include "cell/upper_map.h"
#include "contacts/elastic_laws.h"
#include "core/lanes.h"
#include "jamming/cell_motion.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

constexpr Count block_size = ContactTiles::particles_per_block;

void kick_cell(JamState& state, const NphSettings& settings) {
    const double half = 0.5 * settings.time_step;
    const Mat3 push =
        state.cell.volume() / settings.cell_inertia * (state.pressure - settings.applied_pressure);
    const double kept = std::exp(-settings.cell_damping * half);
    state.velocity_gradient =
        allowed_strain(state.velocity_gradient * kept + half * push, settings.free_cell);
}

/// One half-kick of a particle: v' = v + half (F/m - L^T v). Four numbers at a time, the mass last
/// and kept.
class HalfKick {
  public:
    HalfKick(const Mat3& gradient, double half)
        : half_(half),
          from_x_{-half * gradient(0, 0), -half * gradient(0, 1), -half * gradient(0, 2), 0.0},
          from_y_{0.0, -half * gradient(1, 1), -half * gradient(1, 2), 0.0},
          from_z_{0.0, 0.0, -half * gradient(2, 2), 0.0} {}

    Double4 operator()(const Double4& motion, const Double4& load) const {
        const double per_mass = half_ / motion[3];
        const Double4 push = {per_mass * load[0], per_mass * load[1], per_mass * load[2], 0.0};
        return motion + (push + from_x_ * motion[0] + from_y_ * motion[1] + from_z_ * motion[2]);
    }

  private:
    double half_;
    Double4 from_x_, from_y_, from_z_;
};

double squared_length(const Double4& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/// Half-kicks the particles, drifts them and the cell.
StepMotion kick_and_drift(JamState& state, const NphSettings& settings) {
    const HalfKick kick(state.velocity_gradient, 0.5 * settings.time_step);
    const Mat3 strain = state.velocity_gradient * settings.time_step;
    const UpperMap drift(strained_cell(state.cell, 0.5 * strain).inverse() * settings.time_step);
    state.cell = strained_cell(state.cell, strain);
    Particles& particles = state.particles;
    const double squared = max_blocks(particles.size(), block_size, [&](Count begin, Count end) {
        double largest = 0.0;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            const Double4 motion = kick(load4(particles.motions[i]), load4(particles.loads[i]));
            const Double4 sphere = load4(particles.spheres[i]) + drift(motion);
            store4(motion, particles.motions[i]);
            store4(sphere, particles.spheres[i]);
            largest = std::max(largest, squared_length(motion));
        }
        return largest;
    });
    return {std::sqrt(squared) * settings.time_step, strain.norm()};
}

/// What the second half-kick sums as it goes: sum m v v^T by rows, and the largest speed.
struct MotionSums {
    Double4 flux_x{}, flux_y{}, flux_z{};
    double largest_speed_squared = 0.0;

    void add(const Double4& motion) {
        const Double4 momentum = motion * motion[3];
        flux_x += momentum * motion[0];
        flux_y += momentum * motion[1];
        flux_z += momentum * motion[2];
        largest_speed_squared = std::max(largest_speed_squared, squared_length(motion));
    }
    MotionSums& operator+=(const MotionSums& other) {
        flux_x += other.flux_x;
        flux_y += other.flux_y;
        flux_z += other.flux_z;
        largest_speed_squared = std::max(largest_speed_squared, other.largest_speed_squared);
        return *this;
    }
    Mat3 momentum_flux() const {
        Mat3 flux;
        for (int k = 0; k < 3; ++k) flux.col(k) = Vec3(flux_x[k], flux_y[k], flux_z[k]);
        return flux;
    }
};

MotionSums finish_loads_and_kick(JamState& state, const NphSettings& settings,
                                 NphScratch& scratch) {
    const HalfKick kick(state.velocity_gradient, 0.5 * settings.time_step);
    Particles& particles = state.particles;
    return sum_blocks(particles.size(), block_size, MotionSums{}, [&](Count begin, Count end) {
        add_halo_loads(scratch.lists.tiles, begin / block_size, scratch.forces.slots,
                       particles.loads);
        MotionSums sums;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            const Double4 motion = kick(load4(particles.motions[i]), load4(particles.loads[i]));
            store4(motion, particles.motions[i]);
            sums.add(motion);
        }
        return sums;
    });
}

void evaluate_forces(const JamState& state, const NphSettings& settings, NphScratch& scratch,
                     std::vector<Load>& loads) {
    const ContactFlow flow{.damped = settings.material.damping > 0.0,
                           .velocity_gradient = state.velocity_gradient};
    scratch.sums = contact_forces(state.cell, settings.material, flow, scratch.lists.tiles,
                                  state.particles, loads, scratch.forces);
}

void search(JamState& state, const StepMotion& moved, NphScratch& scratch) {
    const StageTimer timer(scratch.times, Stage::search);
    reduce_tilt(state);
    renew_lists(scratch.lists, state.cell, moved, scratch.motion, state.particles);
    state.list_reference = scratch.lists.outer;
}

void keep_lists_valid(JamState& state, const StepMotion& moved, NphScratch& scratch) {
    ListRenewal renewal;
    {
        const StageTimer timer(scratch.times, Stage::refilter);
        renewal =
            keep_tiles_valid(scratch.lists, state.cell, moved, scratch.motion, state.particles);
    }
    if (renewal == ListRenewal::search_needed) search(state, moved, scratch);
}

void take_internal_pressure(JamState& state, const NphScratch& scratch, const Mat3& momentum_flux) {
    state.pressure = (momentum_flux + scratch.sums.virial) / state.cell.volume();
}

}  // namespace

double highest_frequency(const Material& material, const Particles& particles) {
    double smallest = particles.spheres.front().diameter;
    for (const Sphere& sphere : particles.spheres) smallest = std::min(smallest, sphere.diameter);
    double highest = 0.0;
    for (std::size_t i = 0; i < particles.spheres.size(); ++i) {
        const double diameter = particles.spheres[i].diameter;
        // Twelve equal spheres fit around one; smaller ones cover it in proportion to its surface.
        const double contacts = 12.0 * std::pow(0.5 * (diameter / smallest + 1.0), 2.0);
        const double deep_overlap = 0.1 * smallest;
        const double tangent = with_elastic_law(material, [&](const auto& law) {
            return law.tangent(deep_overlap, diameter, diameter);
        });
        // A third of the contacts resists each direction; neighbors as light as itself double it.
        const double squared = 2.0 * contacts * tangent / (3.0 * particles.motions[i].mass);
        highest = std::max(highest, std::sqrt(squared));
    }
    return highest;
}

double stability_limit(const Material& material, const Particles& particles) {
    const double frequency = highest_frequency(material, particles);
    const double damping_rate = 4.0 * material.damping;
    return 4.0 / (damping_rate + std::hypot(damping_rate, 2.0 * frequency));
}

static double automatic_time_step(const Material& material, const Particles& particles) {
    return std::min(0.25 / highest_frequency(material, particles),
                    0.22 * stability_limit(material, particles));
}

NphSettings nph_settings(const Scene& scene, const JamState& state) {
    // By id, so that a run which goes on from sorted particles adds in the same order.
    const std::vector<double> diameters = diameters_by_id(state.particles);
    const double smallest = *std::min_element(diameters.begin(), diameters.end());
    double inertia = 0.0;
    double volume = 0.0;
    for (const double diameter : diameters) {
        inertia += diameter * diameter *
                   inertial_mass(diameter, smallest, scene.protocol.masses, scene.contact.density);
        volume += sphere_volume(diameter);
    }
    const double tau = unit_of_time(scene.contact, smallest);
    const double mean_pressure = scene.protocol.pressure.trace() / 3.0;

    NphSettings settings;
    settings.material = scene.contact;
    settings.applied_pressure = scene.protocol.pressure;
    settings.free_cell = scene.protocol.free_cell;
    settings.time_step = scene.protocol.time_step
                             ? *scene.protocol.time_step * tau
                             : automatic_time_step(scene.contact, state.particles);
    settings.cell_inertia = scene.protocol.cell_inertia * inertia;
    settings.cell_damping =
        scene.protocol.cell_damping * std::sqrt(mean_pressure * volume / settings.cell_inertia);
    return settings;
}

void begin_nph(JamState& state, const NphSettings& settings, NphScratch& scratch) {
    scratch.motion.strain = state.velocity_gradient.norm() * settings.time_step;
    if (!state.list_reference.centers.empty()) {
        const std::vector<Load> loads = state.particles.loads;
        restore_lists(scratch.lists, state.list_reference, state.cell, scratch.motion,
                      state.particles);
        state.particles.loads = loads;
        std::vector<Load> unused = loads;
        evaluate_forces(state, settings, scratch, unused);
        return;
    }
    scratch.lists.hierarchy.group(state.particles);
    search(state, StepMotion{}, scratch);
    evaluate_forces(state, settings, scratch, state.particles.loads);
    add_halo_loads(scratch.lists.tiles, scratch.forces.slots, state.particles.loads);
    take_internal_pressure(state, scratch, Mat3::Zero());
}

void nph_step(JamState& state, const NphSettings& settings, NphScratch& scratch) {
    kick_cell(state, settings);
    StepMotion moved;
    {
        const StageTimer timer(scratch.times, Stage::integrate);
        moved = kick_and_drift(state, settings);
    }
    keep_lists_valid(state, moved, scratch);
    {
        const StageTimer timer(scratch.times, Stage::forces);
        evaluate_forces(state, settings, scratch, state.particles.loads);
    }
    const StageTimer timer(scratch.times, Stage::integrate);
    const MotionSums sums = finish_loads_and_kick(state, settings, scratch);
    take_internal_pressure(state, scratch, sums.momentum_flux());
    kick_cell(state, settings);
    scratch.motion = {std::sqrt(sums.largest_speed_squared) * settings.time_step,
                      state.velocity_gradient.norm() * settings.time_step};
    ++state.step;
    state.time += settings.time_step;
}

double enthalpy(const JamState& state, const NphSettings& settings, const NphScratch& scratch) {
    double kinetic = 0.0;
    for (const Motion& motion : state.particles.motions)
        kinetic += 0.5 * motion.mass * motion.velocity.squaredNorm();
    return kinetic + scratch.sums.energy +
           0.5 * settings.cell_inertia * state.velocity_gradient.squaredNorm() +
           settings.applied_pressure.trace() / 3.0 * state.cell.volume();
}

}  // namespace jam
