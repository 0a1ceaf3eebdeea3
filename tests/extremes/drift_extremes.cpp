// SPDX-License-Identifier: BSD-3-Clause
// What round-off adds up to over very many steps: few spheres, held by their stress, step after
// step. 10^8 steps of a large packing are out of a test's reach; how the error grows is not.
#include "jamming/cell_motion.h"
#include "jamming/jam_packing.h"
#include "jamming/nph_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace jam {
namespace {

constexpr double pressure = 1e-3;
constexpr double round_off = 2.2e-16;

Scene scene_of(double damping) {
    Scene scene;
    scene.sizes.distribution = PowerLaw{2.0, 0.55};
    scene.sizes.count = 40;
    scene.contact.damping = damping;
    scene.protocol.pressure = Mat3::Identity() * pressure;
    scene.run.threads = 1;
    return scene;
}

/// A jammed packing at rest, to be taken further by nph steps.
struct Held {
    explicit Held(double damping)
        : scene(scene_of(damping)), state(start_state(scene)), scratch(diameters(), {}) {
        EXPECT_EQ(jam_packing(scene, state).outcome, JamOutcome::converged);
        state.list_reference = {};
        state.velocity_gradient.setZero();
        for (Motion& motion : state.particles.motions) motion.velocity.setZero();
        set_masses(state.particles, Masses::true_mass, scene.contact.density);
        settings = nph_settings(scene, state);
        settings.cell_damping = damping > 0.0 ? settings.cell_damping : 0.0;
        begin_nph(state, settings, scratch);
    }
    void advance(int steps) {
        for (int step = 0; step < steps; ++step) nph_step(state, settings, scratch);
    }
    std::vector<double> diameters() const { return diameters_by_id(state.particles); }

    Scene scene;
    JamState state;
    NphSettings settings;
    NphScratch scratch;
};

/// Momentum over the sum of its magnitudes.
double relative_momentum(const JamState& state) {
    Vec3 momentum = Vec3::Zero();
    double magnitude = 0.0;
    for (const Motion& motion : state.particles.motions) {
        momentum += motion.mass * motion.velocity;
        magnitude += motion.mass * motion.velocity.norm();
    }
    return momentum.norm() / magnitude;
}

/// Sets all in motion without a momentum of the whole.
void shake(JamState& state, double speed) {
    Vec3 momentum = Vec3::Zero();
    double mass = 0.0;
    for (std::size_t i = 0; i < state.particles.motions.size(); ++i) {
        Motion& motion = state.particles.motions[i];
        const auto k = static_cast<double>(i);
        motion.velocity = speed * Vec3(std::sin(12.9 * k), std::sin(78.2 * k), std::sin(37.7 * k));
        momentum += motion.mass * motion.velocity;
        mass += motion.mass;
    }
    for (Motion& motion : state.particles.motions) motion.velocity -= momentum / mass;
}

TEST(DriftExtremes, MomentumAndEnthalpyOfAMotionWithoutEnd) {
    Held held(0.0);
    shake(held.state, 1e-4);
    const double before = enthalpy(held.state, held.settings, held.scratch);
    const double moving = before - pressure * held.state.cell.volume();
    double worst_momentum = 0.0;
    double worst_enthalpy = 0.0;
    double asymmetry = 0.0;
    for (int block = 0; block < 100; ++block) {
        held.advance(2000);
        worst_momentum = std::max(worst_momentum, relative_momentum(held.state));
        worst_enthalpy = std::max(
            worst_enthalpy, std::abs(enthalpy(held.state, held.settings, held.scratch) - before));
        const Mat3& p = held.state.pressure;
        asymmetry = std::max(asymmetry, (p - p.transpose()).cwiseAbs().maxCoeff() / pressure);
    }
    RecordProperty("momentum", std::to_string(worst_momentum / round_off));
    RecordProperty("enthalpy", std::to_string(worst_enthalpy / moving));
    RecordProperty("asymmetry", std::to_string(asymmetry / round_off));
    EXPECT_GT(relative_momentum(held.state), 0.0);  // it is round-off that is measured
    EXPECT_LT(worst_momentum, 1e-11);
    EXPECT_LT(worst_enthalpy, 1e-2 * moving);
    EXPECT_LT(asymmetry, 10.0 * round_off);
    EXPECT_TRUE(held.state.particles.motions[0].velocity.allFinite());
}

TEST(DriftExtremes, AJammedPackingDoesNotCreep) {
    Held held(0.5);
    held.advance(20'000);  // what the relaxation has left
    const Mat3 cell = held.state.cell.matrix();
    const std::vector<Sphere> spheres = held.state.particles.spheres;
    held.advance(200'000);
    const double creep =
        (held.state.cell.matrix() - cell).cwiseAbs().maxCoeff() / cell.cwiseAbs().maxCoeff();
    RecordProperty("creep", std::to_string(creep / round_off));
    EXPECT_LT(creep, 200'000 * round_off);  // less than one rounding a step
    EXPECT_LT((held.state.pressure - held.settings.applied_pressure).cwiseAbs().maxCoeff(),
              1e-9 * pressure);
    double kinetic = 0.0;
    for (const Motion& motion : held.state.particles.motions)
        kinetic = std::max(kinetic, 0.5 * motion.mass * motion.velocity.squaredNorm());
    EXPECT_LT(kinetic, 1e-25);
}

TEST(DriftExtremes, ACellThatGoesToAndFroComesBack) {
    // A strain and its opposite, two million times: to second order each pair leaves strain^4 / 4.
    Mat3 strain = Mat3::Zero();
    strain(0, 0) = 1e-5;
    strain(1, 1) = -2e-5;
    strain(0, 1) = 3e-5;
    strain(1, 2) = -1e-5;
    const PeriodicCell before((Mat3() << 3.0, 1.0, -0.5, 0.0, 4.0, 1.5, 0.0, 0.0, 5.0).finished());
    PeriodicCell cell = before;
    constexpr int times = 2'000'000;
    for (int k = 0; k < times; ++k) cell = strained_cell(strained_cell(cell, strain), -strain);
    const double drift = (cell.matrix() - before.matrix()).cwiseAbs().maxCoeff() / 5.0;
    RecordProperty("drift", std::to_string(drift / round_off));
    EXPECT_LT(drift, times * round_off);  // less than half a rounding a strain
    EXPECT_GT(drift, 0.0);
}

}  // namespace
}  // namespace jam
