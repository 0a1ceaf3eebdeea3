// SPDX-License-Identifier: BSD-3-Clause
// Time steps at the stability limit and past it.
#include "contacts/elastic_laws.h"
#include "extremes/jamming_run.h"
#include "jamming/nph_step.h"
#include "jamming/quasistatic.h"
#include "support/packings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

using test::expect_refused;
using test::few_spheres;
using test::JammingRun;
using test::JammingRuns;

constexpr double aside = 1e-6;

/// A crystal in which every sphere has twelve neighbors, pressed so that none is lost, each sphere
/// about `aside` out of place.
JamState pressed_crystal() {
    const Packing crystal = test::face_centered_cubic(3, std::sqrt(2.0) * 0.98, 1.0);
    JamState state;
    state.cell = crystal.cell;
    for (std::size_t i = 0; i < crystal.positions.size(); ++i) {
        const auto k = static_cast<double>(i);
        const Vec3 way(std::sin(12.9 * k), std::sin(78.2 * k), std::sin(37.7 * k));
        state.particles.spheres.push_back(
            {wrapped(state.cell.fractional(crystal.positions[i] + aside * way)), 1.0});
        state.particles.motions.push_back({Vec3::Zero(), sphere_volume(1.0)});
        state.particles.ids.push_back(static_cast<std::uint32_t>(i));
    }
    state.particles.loads.assign(state.particles.spheres.size(), Load{Vec3::Zero(), 0.0});
    return state;
}

double net_force_squared(const JamState& state) {
    double sum = 0.0;
    for (const Load& load : state.particles.loads) sum += load.force.squaredNorm();
    return sum;
}

/// Square of the net forces after 1500 steps, in a cell that does not move, over (k aside)^2 of
/// every sphere. Not the kinetic energy: velocities that change sign at every step average out.
double unrest_at_the_end(double damping, double limits) {
    JamState state = pressed_crystal();
    NphSettings settings;
    settings.material.damping = damping;
    settings.time_step = limits * stability_limit(settings.material, state.particles);
    settings.cell_inertia = 1e30;
    NphScratch scratch(diameters_by_id(state.particles), {});
    begin_nph(state, settings, scratch);
    double largest = 0.0;
    for (int step = 0; step < 1500; ++step) {
        nph_step(state, settings, scratch);
        const double squared = net_force_squared(state);
        if (step >= 1400) largest = std::max(largest, squared);
        if (!(squared < 100.0)) return 1e30;
    }
    return largest / (static_cast<double>(state.particles.size()) * aside * aside);
}

TEST(TimeStepExtremes, TheLimitIsThatOfACrystal) {
    // Springs between nearest neighbors of a face-centered cubic crystal: w^2 = 8 k / m at most.
    const JamState state = pressed_crystal();
    EXPECT_NEAR(highest_frequency({}, state.particles), std::sqrt(8.0 / sphere_volume(1.0)), 1e-12);
    // Prestress lowers it by about the overlap, 0.02.
    for (const double damping : {0.0, 0.5, 50.0}) {
        EXPECT_LT(unrest_at_the_end(damping, 0.97), 1e4) << damping;
        EXPECT_GT(unrest_at_the_end(damping, 1.06), 1e6) << damping;
    }
}

TEST(TimeStepExtremes, TheAutomaticStepsStandBelowTheLimit) {
    for (const ContactLaw law : {ContactLaw::hooke, ContactLaw::hertz}) {
        for (const double damping : {0.0, 0.5, 50.0, 1e6}) {
            for (const double size_ratio : {1.0, 3.0, 20.0}) {
                Scene scene;
                scene.contact.law = law;
                scene.contact.damping = damping;
                scene.sizes.distribution = PowerLaw{size_ratio, 1.0};
                scene.sizes.count = 100;
                scene.start.volume_fraction = 0.1;
                const JamState state = start_state(scene);
                const double limit = stability_limit(scene.contact, state.particles);
                const NphSettings settings = nph_settings(scene, state);
                EXPECT_LE(settings.time_step, 0.25 * limit);
                EXPECT_GT(settings.time_step, 0.1 * limit);

                JamState compacting = state;
                const QuasistaticRun run(scene, compacting);
                const NphSettings compaction = quasistatic_settings(scene, compacting).compaction;
                EXPECT_LE(compaction.time_step,
                          0.9 * stability_limit(compaction.material, compacting.particles));
                EXPECT_EQ(compaction.time_step, run.time_step());
            }
        }
    }
}

TEST(TimeStepExtremes, AStepPastTheLimitIsRefusedBeforeAnythingIsWritten) {
    JammingRuns jam;
    for (const char* kind : {"nph", "quasistatic"}) {
        for (const char* step : {"0.75", "2", "10"}) {
            const JammingRun run =
                jam(test::equal_spheres, {fmt::format("protocol.kind={}", kind),
                                          fmt::format("protocol.time_step={}", step)});
            expect_refused(run, {fmt::format("protocol.time_step = {}", step), "stability limit",
                                 "\"automatic\""});
            EXPECT_FALSE(run.left_files);
        }
        expect_refused(jam(test::equal_spheres, {"protocol.time_step=10.1"}),
                       {"protocol.time_step", "at most 10"});
    }
}

TEST(TimeStepExtremes, HeavyDampingLowersTheLimit) {
    JammingRuns jam;
    const std::vector<std::string> sets = {"protocol.kind=nph", "protocol.pressure=1e-2",
                                           "stop.max_steps=500", "protocol.time_step=0.3"};
    EXPECT_EQ(jam(test::equal_spheres, sets).status, 3);
    std::vector<std::string> damped = sets;
    damped.emplace_back("contact.damping=50");
    expect_refused(jam(test::equal_spheres, damped), {"protocol.time_step = 0.3", "0.0138"});
}

TEST(TimeStepExtremes, JustBelowTheLimitAPackingStillJams) {
    JammingRuns jam;
    test::expect_jammed(jam(few_spheres, {"protocol.time_step=0.5"}), 1e-6);
}

}  // namespace
}  // namespace jam
