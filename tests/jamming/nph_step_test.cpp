// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/nph_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace jam {
namespace {

/// Two unit spheres that approach along a line, in a cell that does not move.
JamState collision(double speed) {
    JamState state;
    state.cell = PeriodicCell::cubic(10.0);
    state.particles.spheres = {{Vec3(0.45, 0.5, 0.5), 1.0}, {Vec3(0.55, 0.5, 0.5), 1.0}};
    const double mass = sphere_volume(1.0);
    state.particles.motions = {{Vec3(0.5 * speed, 0.0, 0.0), mass},
                               {Vec3(-0.5 * speed, 0.0, 0.0), mass}};
    state.particles.loads.assign(2, Load{Vec3::Zero(), 0.0});
    state.particles.ids = {0, 1};
    return state;
}

NphSettings fixed_cell(double damping, double time_step) {
    NphSettings settings;
    settings.material.damping = damping;
    settings.time_step = time_step;
    settings.cell_inertia = 1e30;
    return settings;
}

double separation(const JamState& state) {
    const auto& spheres = state.particles.spheres;
    return std::abs(state.cell.cartesian(spheres[0].center - spheres[1].center)[0]);
}

/// Overlap of the damped oscillator M_eff x'' = -k x - M_eff gamma x' that starts with x = 0, x' =
/// v.
double analytic_overlap(double time, double speed, double damping) {
    const double effective_mass = 0.5 * sphere_volume(1.0);
    const double omega = std::sqrt(1.0 / effective_mass - 0.25 * damping * damping);
    return speed / omega * std::exp(-0.5 * damping * time) * std::sin(omega * time);
}

TEST(NphStep, CollisionFollowsTheDampedOscillatorWhileItRepels) {
    const double speed = 0.02;
    for (const double damping : {0.0, 0.5}) {
        std::vector<double> errors;
        for (const double time_step : {0.02, 0.01}) {
            JamState state = collision(speed);
            const NphSettings settings = fixed_cell(damping, time_step);
            NphScratch scratch(diameters_by_id(state.particles), {});
            begin_nph(state, settings, scratch);
            double worst = 0.0;
            for (int step = 0; step < static_cast<int>(1.0 / time_step); ++step) {
                nph_step(state, settings, scratch);
                worst = std::max(worst, std::abs(1.0 - separation(state) -
                                                 analytic_overlap(state.time, speed, damping)));
            }
            EXPECT_GT(analytic_overlap(0.5, speed, damping), 5e-3);
            errors.push_back(worst);
        }
        EXPECT_LT(errors[0], 5e-5);
        // The undamped scheme is of second order; damping forces lag by half a step and are of
        // first.
        EXPECT_LT(errors[1], errors[0] * (damping == 0.0 ? 0.3 : 0.6));
    }
}

TEST(NphStep, CollisionEndsWithTheRestitutionOfAForceThatNeverPulls) {
    const double damping = 0.5;
    const double speed = 0.02;
    JamState state = collision(speed);
    const NphSettings settings = fixed_cell(damping, 0.001);
    NphScratch scratch(diameters_by_id(state.particles), {});
    begin_nph(state, settings, scratch);
    for (int step = 0; step < 4000; ++step) nph_step(state, settings, scratch);
    ASSERT_GT(separation(state), 1.0);
    // The force vanishes where k x = -M_eff gamma x', before the overlap does; from there the
    // spheres fly apart freely (Schwager and Poeschel, 2007).
    const double effective_mass = 0.5 * sphere_volume(1.0);
    const double half = 0.5 * damping;
    const double omega = std::sqrt(1.0 / effective_mass - half * half);
    const double end =
        (std::numbers::pi - std::atan2(2.0 * half * omega, omega * omega - half * half)) / omega;
    const double expected = std::exp(-half * end);
    const auto& motions = state.particles.motions;
    const double leaving = std::abs(motions[0].velocity[0] - motions[1].velocity[0]);
    EXPECT_NEAR(leaving / speed, expected, 1e-3);
    // Without the switch it would be exp(-gamma pi / (2 omega)): the two must be told apart.
    EXPECT_GT(std::abs(expected - std::exp(-half * std::numbers::pi / omega)), 5e-3);
}

/// A small scene in motion, dense enough to have contacts all the time.
Scene small_nph_scene() {
    Scene scene;
    PowerLaw law;
    law.size_ratio = 3.0;
    law.alpha = 0.8;
    scene.sizes.distribution = law;
    scene.sizes.count = 600;
    scene.start.volume_fraction = 0.45;
    scene.protocol.pressure = Mat3::Identity() * 1e-2;
    return scene;
}

struct Moving {
    JamState state;
    NphSettings settings;
    NphScratch scratch;
};

Moving moving(const Scene& scene) {
    JamState state = start_state(scene);
    const NphSettings settings = nph_settings(scene, state);
    Moving run{state, settings, NphScratch(diameters_by_id(state.particles), {})};
    begin_nph(run.state, run.settings, run.scratch);
    return run;
}

TEST(NphStep, ConservesEnthalpyWithoutDampingToSecondOrder) {
    std::vector<double> drifts;
    for (const double time_step : {0.1, 0.025}) {
        Scene scene = small_nph_scene();
        scene.contact.damping = 0.0;
        scene.protocol.cell_damping = 0.0;
        scene.protocol.time_step = time_step;
        Moving run = moving(scene);
        const double before = enthalpy(run.state, run.settings, run.scratch);
        const double volume = run.state.cell.volume();
        double worst = 0.0;
        for (int step = 0; step < static_cast<int>(60.0 / time_step); ++step) {
            nph_step(run.state, run.settings, run.scratch);
            worst =
                std::max(worst, std::abs(enthalpy(run.state, run.settings, run.scratch) - before));
        }
        // Real motion: the cell gave a good part of its p V to the particles, and tilted.
        EXPECT_LT(run.state.cell.volume(), 0.9 * volume);
        EXPECT_GT(run.scratch.sums.contacts, 100);
        EXPECT_FALSE(run.state.cell.is_orthogonal());
        drifts.push_back(worst / before);
    }
    EXPECT_LT(drifts[0], 2e-3);
    // A first-order scheme would gain no more than a factor of four.
    EXPECT_LT(drifts[1], 0.2 * drifts[0]);
}

TEST(NphStep, DampingOnlyTakesEnthalpyAway) {
    Moving run = moving(small_nph_scene());
    const double first = enthalpy(run.state, run.settings, run.scratch);
    double before = first;
    for (int block = 0; block < 20; ++block) {
        for (int step = 0; step < 50; ++step) nph_step(run.state, run.settings, run.scratch);
        const double now = enthalpy(run.state, run.settings, run.scratch);
        EXPECT_LT(now, before + 1e-6 * first);
        before = now;
    }
    EXPECT_LT(before, 0.9 * first);
}

TEST(NphStep, MomentumStaysZero) {
    Moving run = moving(small_nph_scene());
    for (int step = 0; step < 1500; ++step) nph_step(run.state, run.settings, run.scratch);
    Vec3 momentum = Vec3::Zero();
    double magnitude = 0.0;
    for (const Motion& motion : run.state.particles.motions) {
        momentum += motion.mass * motion.velocity;
        magnitude += motion.mass * motion.velocity.norm();
    }
    EXPECT_GT(magnitude, 1e-3);
    EXPECT_LT(momentum.norm(), 1e-11 * magnitude);
}

TEST(NphStep, ASceneWithoutTiltStaysOrthogonalAndAnIsotropicOneKeepsItsShape) {
    for (const FreeCell free_cell : {FreeCell::orthogonal, FreeCell::isotropic}) {
        Scene scene = small_nph_scene();
        scene.protocol.free_cell = free_cell;
        Moving run = moving(scene);
        const Mat3 before = run.state.cell.matrix();
        for (int step = 0; step < 500; ++step) nph_step(run.state, run.settings, run.scratch);
        const Mat3& h = run.state.cell.matrix();
        EXPECT_TRUE(run.state.cell.is_orthogonal());
        EXPECT_LT(h(0, 0), 0.99 * before(0, 0));
        if (free_cell == FreeCell::isotropic) {
            EXPECT_NEAR(h(0, 0) / h(1, 1), before(0, 0) / before(1, 1), 1e-12);
        } else {
            EXPECT_GT(std::abs(h(0, 0) / h(1, 1) - 1.0), 1e-6);
        }
    }
}

TEST(NphStep, AutomaticTimeStepFollowsTheStiffestParticle) {
    Scene scene = small_nph_scene();
    const JamState state = start_state(scene);
    const double usual = nph_settings(scene, state).time_step;
    scene.contact.stiffness *= 4.0;
    EXPECT_NEAR(nph_settings(scene, state).time_step, 0.5 * usual, 1e-12 * usual);
}

}  // namespace
}  // namespace jam
