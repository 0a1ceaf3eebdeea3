// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/quasistatic.h"

#include "jamming/checkpoint_file.h"
#include "jamming/jam_packing.h"
#include "support/scratch_folder.h"
#include "support/state_bits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>

namespace jam {
namespace {

using test::bits_of;

Scene small_scene(Count count) {
    Scene scene;
    PowerLaw law;
    law.size_ratio = 2.0;
    law.alpha = 0.5;
    scene.sizes.distribution = law;
    scene.sizes.count = count;
    scene.protocol.pressure = Mat3::Identity() * 1e-4;
    scene.protocol.descent.compaction_steps = 2000;
    scene.stop.max_steps = 400'000;
    scene.run.record_interval = 1000;
    scene.run.threads = 1;
    return scene;
}

TEST(Quasistatic, ComesToRestAtTheAppliedPressureAndStands) {
    const Scene scene = small_scene(250);
    JamState state = start_state(scene);
    const JamResult result = jam_packing(scene, state);
    ASSERT_EQ(result.outcome, JamOutcome::converged) << to_text(result.verdict);
    ASSERT_EQ(result.verdict.criteria.size(), 4u);
    const PackingStatistics& now = result.measurement.statistics;
    EXPECT_LT(now.cundall, 1e-6);
    EXPECT_LT((now.pressure - scene.protocol.pressure).cwiseAbs().maxCoeff(), 1e-4 * 1e-4);
    EXPECT_GE(now.excess_contact_count(), 0);
    EXPECT_GT(now.volume_fraction, 0.6);
    EXPECT_LT(now.volume_fraction, 0.72);
    EXPECT_EQ(now.kinetic_energy_per_particle, 0.0);
}

TEST(Quasistatic, AStopThatFindsItConvergedIsItsEnd) {
    Scene scene = small_scene(60);
    JamState state = start_state(scene);
    ASSERT_EQ(jam_packing(scene, state).outcome, JamOutcome::converged);
    scene.run.record_interval = 1'000'000;
    state.quasistatic.at_rest = false;
    ASSERT_FALSE(ending_without_a_step(scene, state)) << "as between two verdicts";
    const JamResult stopped = jam_packing(scene, state, {.stop_requested = [] { return true; }});
    ASSERT_EQ(stopped.outcome, JamOutcome::converged) << to_text(stopped.verdict);
    const std::optional<JamResult> ending = ending_without_a_step(scene, state);
    ASSERT_TRUE(ending);
    EXPECT_EQ(ending->outcome, JamOutcome::converged);
    scene.stop.cundall = 1e-300;
    EXPECT_FALSE(ending_without_a_step(scene, state)) << "by the criteria as they are now";
}

TEST(Quasistatic, FastEndsSoonerWithoutAWordOnStability) {
    Scene scene = small_scene(250);
    JamState state = start_state(scene);
    const Count standard = (jam_packing(scene, state), state.step);
    scene.protocol.accuracy = Accuracy::fast;
    take_defaults_of_accuracy(scene);
    state = start_state(scene);
    const JamResult result = jam_packing(scene, state);
    ASSERT_EQ(result.outcome, JamOutcome::converged) << to_text(result.verdict);
    EXPECT_EQ(result.verdict.criteria.size(), 2u);
    EXPECT_LT(state.step, standard);
}

TEST(Quasistatic, SameBitsForAnyThreadCount) {
    const auto bits_with = [](int threads) {
        Scene scene = small_scene(3000);
        scene.protocol.descent.compaction_steps = 800;
        scene.stop.max_steps = 1000;
        scene.run.threads = threads;
        JamState state = start_state(scene);
        jam_packing(scene, state);
        return bits_of(state);
    };
    const std::uint64_t alone = bits_with(1);
    for (const int threads : {2, 3, 5, 8}) EXPECT_EQ(bits_with(threads), alone) << threads;
}

TEST(Quasistatic, GoesOnWithTheSameBitsWhereverItWasStopped) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "widejam_quasistatic_resume.h5";
    Scene scene = small_scene(250);
    scene.protocol.descent.compaction_steps = 500;
    scene.stop.max_steps = 2500;
    JamState whole = start_state(scene);
    jam_packing(scene, whole);
    for (const Count stop_at : {300, 500, 501, 733, 1999}) {
        JamState state = start_state(scene);
        jam_packing(scene, state, {.stop_requested = [&] { return state.step >= stop_at; }});
        ASSERT_EQ(state.step, stop_at);
        save_checkpoint(state, "scene", file);
        Checkpoint checkpoint = load_checkpoint(file);
        jam_packing(scene, checkpoint.state);
        EXPECT_EQ(bits_of(checkpoint.state), bits_of(whole)) << "stopped at " << stop_at;
    }
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + ".previous");
}

/// Never judged to be at rest, so that it creeps on and leaps.
Scene creeping_scene() {
    Scene scene = small_scene(250);
    scene.protocol.free_cell = FreeCell::orthogonal;  // where Newton's method does not serve
    scene.stop.cundall = 1e-3;
    scene.stop.pressure = 1e-15;
    scene.stop.max_steps = 60'000;
    return scene;
}

TEST(Quasistatic, LeapsFromSaddlesWithTheSameBitsWhereverItWasStopped) {
    const test::ScratchFolder folder;
    const Scene scene = creeping_scene();
    JamState whole = start_state(scene);
    bool looked_back = false;
    Count leaps = 0;
    Count before_a_leap = 0;
    const auto watch = [&] {
        const bool looks_back = !whole.quasistatic.leap.centers.empty();
        if (looked_back && !looks_back) {
            ++leaps;
            before_a_leap = whole.step - 1;
        }
        looked_back = looks_back;
        return false;
    };
    jam_packing(scene, whole, {.stop_requested = watch});
    ASSERT_GT(leaps, 0);
    JamState state = start_state(scene);
    jam_packing(scene, state, {.stop_requested = [&] { return state.step >= before_a_leap; }});
    ASSERT_FALSE(state.quasistatic.leap.centers.empty());
    save_checkpoint(state, "scene", folder / "checkpoint.h5");
    Checkpoint checkpoint = load_checkpoint(folder / "checkpoint.h5");
    jam_packing(scene, checkpoint.state);
    EXPECT_EQ(bits_of(checkpoint.state), bits_of(whole));
}

/// Factor by which one step changes the pressure of a random start far from balance, when the
/// lowest has been `lowest`.
double change_of_pressure(Count count, double pressure, double lowest) {
    Scene scene = small_scene(count);
    scene.protocol.pressure = Mat3::Identity() * 1e-6;
    JamState state = start_state(scene);
    state.cell = PeriodicCell(0.78 * state.cell.matrix());
    state.quasistatic.stage = QuasistaticState::Stage::relaxation;
    state.quasistatic.pressure = pressure;
    state.quasistatic.lowest_pressure = lowest;
    QuasistaticRun run(scene, state);
    run.begin();
    run.advance();
    return state.quasistatic.pressure / pressure;
}

TEST(Quasistatic, OnlyLargePackingsOfSmallOverlapsRiseWhereForcesAreOutOfBalance) {
    constexpr Count small = 250;
    constexpr Count large = 8000;
    EXPECT_GT(change_of_pressure(large, 5e-5, 5e-5), 1.0);
    EXPECT_GT(change_of_pressure(large, 1e-6, 1e-6), 1.0) << "at the foot, too";
    EXPECT_LT(change_of_pressure(large, 2e-4, 2e-4), 1.0);
    EXPECT_LT(change_of_pressure(small, 5e-5, 5e-5), 1.0);
}

TEST(Quasistatic, RisesToTwiceItsLowestPressureAtMost) {
    constexpr Count large = 8000;
    EXPECT_GT(change_of_pressure(large, 1.9e-6, 1e-6), 1.0);
    EXPECT_DOUBLE_EQ(1.99999e-6 * change_of_pressure(large, 1.99999e-6, 1e-6), 2e-6);
    EXPECT_LT(change_of_pressure(large, 2e-6, 1e-6), 1.0);
}

TEST(Quasistatic, BeginsLowerWhereSizesAreWide) {
    const auto first_pressure = [](double size_ratio, ContactLaw law) {
        Scene scene = small_scene(2000);
        PowerLaw sizes;
        sizes.size_ratio = size_ratio;
        sizes.alpha = 1.0;
        scene.sizes.distribution = sizes;
        scene.contact.law = law;
        scene.protocol.pressure = Mat3::Identity() * 1e-9;
        return quasistatic_settings(scene, start_state(scene)).first_pressure;
    };
    EXPECT_NEAR(first_pressure(2.0, ContactLaw::hooke), 1e-3, 1e-6);
    // D_V = (lambda + 1) / 2 at alpha = 1
    EXPECT_NEAR(first_pressure(20.0, ContactLaw::hooke), 5e-3 / 10.5, 0.05 * 5e-3 / 10.5);
    // Hertz: k sqrt(D / 4) delta^1.5 / D^2
    EXPECT_NEAR(first_pressure(2.0, ContactLaw::hertz), 0.5 * std::pow(1e-3, 1.5), 1e-8);
}

}  // namespace
}  // namespace jam
