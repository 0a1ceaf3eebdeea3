// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/relax_step.h"

#include "jamming/jam_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace jam {
namespace {

/// Two hundred spheres of diameters 1 to 6 at random places, so that many overlap.
JamState pressed_spheres() {
    Scene scene;
    PowerLaw law;
    law.size_ratio = 6.0;
    law.alpha = 1.0;
    scene.sizes.distribution = law;
    scene.sizes.count = 200;
    JamState state = start_state(scene);
    state.cell = PeriodicCell(Mat3(0.75 * state.cell.matrix()));
    for (Motion& motion : state.particles.motions) motion = {Vec3::Zero(), 1.0};
    return state;
}

RelaxScratch begin(JamState& state, const RelaxSettings& settings) {
    RelaxScratch scratch(diameters_by_id(state.particles), ListSettings{});
    begin_relaxation(state, settings, scratch);
    return scratch;
}

std::set<Index> active_ones(const ActiveParticles& active) {
    std::set<Index> all;
    for (Count block = 0; block < active.block_count(); ++block)
        all.insert(active.of_block(block).begin(), active.of_block(block).end());
    return all;
}

bool touches_another(const JamState& state, std::size_t i) {
    const std::vector<Sphere>& spheres = state.particles.spheres;
    for (std::size_t j = 0; j < spheres.size(); ++j) {
        if (j == i) continue;
        Vec3 apart = spheres[i].center - spheres[j].center;
        for (int k = 0; k < 3; ++k) apart[k] -= std::round(apart[k]);
        const double reach = 0.5 * (spheres[i].diameter + spheres[j].diameter);
        if (state.cell.cartesian(apart).norm() < reach) return true;
    }
    return false;
}

TEST(RelaxStep, WhoeverIsNotActiveTouchesNothingAndStandsStill) {
    JamState state = pressed_spheres();
    const RelaxSettings settings{.material = {}, .pressure = Mat3::Identity() * 1e-3};
    RelaxScratch scratch = begin(state, settings);
    std::size_t idle = 0;
    for (int step = 0; step < 3000; ++step) {
        relax_step(state, settings, scratch);
        if (step % 100 != 0) continue;
        const std::set<Index> active = active_ones(scratch.active);
        for (Index i = 0; i < state.particles.size(); ++i) {
            if (active.contains(i)) continue;
            const auto at = static_cast<std::size_t>(i);
            ++idle;
            EXPECT_TRUE(is_idle(state.particles, at));
            EXPECT_FALSE(touches_another(state, at)) << "particle " << i << ", step " << step;
        }
    }
    EXPECT_GT(idle, 0u) << "nothing was tested";
}

TEST(RelaxStep, AwakeAreThoseThatAreNotIdle) {
    JamState state = pressed_spheres();
    const RelaxSettings settings{.material = {}, .pressure = Mat3::Identity() * 1e-4};
    RelaxScratch scratch = begin(state, settings);
    Count asleep = 0;
    for (int step = 0; step < 500; ++step) {
        relax_step(state, settings, scratch);
        std::vector<Index> expected;
        for (Index i = 0; i < state.particles.size(); ++i)
            if (!is_idle(state.particles, static_cast<std::size_t>(i))) expected.push_back(i);
        std::vector<Index> awake;
        for (Count block = 0; block < scratch.active.block_count(); ++block)
            for (const Index i : scratch.active.awake_of_block(block)) awake.push_back(i);
        ASSERT_EQ(awake, expected) << "step " << step;
        asleep += state.particles.size() - static_cast<Count>(awake.size());
    }
    EXPECT_GT(asleep, 0) << "nothing was tested";
}

TEST(RelaxStep, EveryActiveParticleHasTheMetricOfItsStiffness) {
    JamState state = pressed_spheres();
    const RelaxSettings settings{.material = {}, .pressure = Mat3::Identity() * 1e-4};
    RelaxScratch scratch = begin(state, settings);
    for (int step = 0; step < 500; ++step) {
        relax_step(state, settings, scratch);
        RelaxationMetric anew;
        forget_metric(state.particles, anew);
        set_metric(state.relax.stiffness, state.particles, scratch.active, anew);
        for (const Index i : active_ones(scratch.active)) {
            const auto at = static_cast<std::size_t>(i);
            const BlockResponse& kept = scratch.metric.particles[at];
            ASSERT_EQ(kept.mass, anew.particles[at].mass) << "particle " << i << ", step " << step;
            ASSERT_EQ(kept.inverse.xy, anew.particles[at].inverse.xy);
        }
    }
    EXPECT_GT(scratch.lists.refilters, 5);
}

TEST(RelaxStep, NobodyGoesFartherThanAFewOverlaps) {
    JamState state = pressed_spheres();
    RelaxSettings settings{.material = {}, .pressure = Mat3::Identity() * 1e-4};
    settings.largest_move = 1.0;
    RelaxScratch scratch = begin(state, settings);
    bool at_the_bound = false;
    for (int step = 0; step < 2000; ++step) {
        const double mean =
            scratch.sums.force_magnitudes / static_cast<double>(scratch.sums.contacts);
        const double bound = std::max(mean, 20.0 * 1e-4);  // stiffness 1, D = 1
        relax_step(state, settings, scratch);
        for (const Motion& motion : state.particles.motions) {
            const double farthest = settings.time_step * motion.velocity.norm();
            ASSERT_LT(farthest, 1.01 * bound) << "step " << step;
            at_the_bound |= farthest > 0.99 * bound;
        }
    }
    EXPECT_TRUE(at_the_bound) << "nothing was tested";
}

/// Largest Cundall parameter of a relaxation to p = 1e-3 from the 500th to the 600th step.
double cundall_with(double look_ahead) {
    JamState state = pressed_spheres();
    const RelaxSettings settings{
        .material = {}, .pressure = Mat3::Identity() * 1e-3, .look_ahead = look_ahead};
    RelaxScratch scratch = begin(state, settings);
    double largest = 0.0;
    for (int step = 0; step < 600; ++step) {
        relax_step(state, settings, scratch);
        if (step >= 500) largest = std::max(largest, scratch.cundall());
    }
    return largest;
}

TEST(RelaxStep, ForcesThatLookAheadBringItToRest) {
    EXPECT_LT(cundall_with(0.6), 0.5 * cundall_with(0.0));
}

TEST(RelaxStep, OneThatMovesIsActiveThoughItTouchesNothing) {
    JamState state = pressed_spheres();
    state.cell = PeriodicCell(Mat3(4.0 * state.cell.matrix()));
    const RelaxSettings settings{.material = {}, .pressure = Mat3::Identity() * 1e-4};
    EXPECT_TRUE(active_ones(begin(state, settings).active).empty());
    state.particles.motions[17].velocity = Vec3(1e-3, 0.0, 0.0);
    RelaxScratch scratch = begin(state, settings);
    ASSERT_EQ(active_ones(scratch.active), std::set<Index>{17});
    const Vec3 before = state.particles.spheres[17].center;
    relax_step(state, settings, scratch);
    EXPECT_NE(state.particles.spheres[17].center, before);
}

TEST(RelaxStep, WhoeverTouchesNothingLosesAFifthAsMuchAndStopsInTheEnd) {
    JamState state = pressed_spheres();
    state.cell = PeriodicCell(Mat3(4.0 * state.cell.matrix()));
    const RelaxSettings settings{.material = {}, .pressure = Mat3::Identity() * 1e-4};
    begin(state, settings);  // sorts
    const Vec3 fast(1e-3, 0.0, 0.0);
    const Vec3 slow(1e-8, 0.0, 0.0);  // the top speed is 20 overlaps of 1e-4 a step
    state.particles.motions[17].velocity = fast;
    state.particles.motions[18].velocity = slow;
    RelaxScratch scratch = begin(state, settings);
    ASSERT_EQ(scratch.sums.contacts, 0);
    relax_step(state, settings, scratch);
    // Without contacts friction takes half of every velocity.
    EXPECT_NEAR(state.particles.motions[17].velocity.x(), (1.0 - 0.2 * 0.5) * fast.x(), 1e-12);
    EXPECT_EQ(state.particles.motions[18].velocity, Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace jam
