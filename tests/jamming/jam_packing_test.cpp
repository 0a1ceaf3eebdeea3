// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/jam_packing.h"

#include "core/check.h"
#include "jamming/checkpoint_file.h"
#include "support/state_bits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace jam {
namespace {

using test::bits_of;

/// Jams within seconds.
Scene quick_scene() {
    Scene scene;
    PowerLaw law;
    law.size_ratio = 2.0;
    law.alpha = 0.5;
    scene.sizes.distribution = law;
    scene.sizes.count = 250;
    scene.protocol.kind = ProtocolKind::nph;
    scene.protocol.pressure = Mat3::Identity() * 1e-2;
    scene.protocol.masses = Masses::diameter;
    scene.stop.cundall = 1e-4;
    scene.stop.kinetic_energy = 1e-8;
    scene.stop.volume_fraction_change = 1e-5;
    scene.stop.coordination_change = 0.02;
    scene.stop.window = 2000;
    scene.stop.max_steps = 200000;
    scene.run.record_interval = 500;
    scene.run.threads = 1;
    return scene;
}

TEST(JamPacking, JamsAndSaysByWhichCriteria) {
    const Scene scene = quick_scene();
    JamState state = start_state(scene);
    std::vector<Record> records;
    const JamResult result = jam_packing(
        scene, state,
        {.on_record = [&](const Record& record, const Verdict&) { records.push_back(record); }});
    EXPECT_EQ(result.outcome, JamOutcome::converged);
    EXPECT_TRUE(result.verdict.converged());
    EXPECT_EQ(result.verdict.criteria.size(), 5u);
    const PackingStatistics& statistics = result.measurement.statistics;
    EXPECT_LT((statistics.pressure - scene.protocol.pressure).cwiseAbs().maxCoeff(), 1e-4 * 1e-2);
    EXPECT_GT(statistics.coordination_nr, 6.0);
    EXPECT_GT(statistics.volume_fraction, 0.6);
    EXPECT_LT(statistics.volume_fraction, 0.75);
    ASSERT_GT(records.size(), 4u);
    EXPECT_EQ(records.back().step, state.step);
    EXPECT_EQ(records.back().volume_fraction, statistics.volume_fraction);
    // At rest the dynamic quantities become the static ones.
    EXPECT_LT((records.back().pressure_dynamic - records.back().pressure).norm(), 1e-5 * 1e-2);
}

TEST(JamPacking, SameBitsForAnyThreadCount) {
    const auto bits_with = [](int threads) {
        Scene scene = quick_scene();
        scene.sizes.count = 5000;
        PowerLaw law;
        law.size_ratio = 12.0;
        law.alpha = 0.9;
        scene.sizes.distribution = law;
        scene.stop.max_steps = 300;
        scene.run.record_interval = 100;
        scene.run.threads = threads;
        JamState state = start_state(scene);
        jam_packing(scene, state);
        return bits_of(state);
    };
    const std::uint64_t alone = bits_with(1);
    for (const int threads : {2, 3, 5, 8, 16}) EXPECT_EQ(bits_with(threads), alone) << threads;
}

class JamPackingResume : public testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() /
            ("widejam_resume_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
             testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path file() const { return folder_ / "checkpoint.h5"; }

    std::filesystem::path folder_;
};

TEST_F(JamPackingResume, EqualsAnUninterruptedRunWhereverItWasStopped) {
    Scene scene = quick_scene();
    scene.stop.max_steps = 3000;
    JamState whole = start_state(scene);
    const JamResult expected = jam_packing(scene, whole);
    for (const Count stop_at : {1, 777, 1500, 2999}) {
        JamState state = start_state(scene);
        const JamResult stopped =
            jam_packing(scene, state, {.stop_requested = [&] { return state.step >= stop_at; }});
        EXPECT_EQ(stopped.outcome, JamOutcome::interrupted);
        EXPECT_EQ(state.step, stop_at);
        save_checkpoint(state, "the scene", file());
        Checkpoint checkpoint = load_checkpoint(file());
        EXPECT_EQ(checkpoint.scene, "the scene");
        EXPECT_EQ(bits_of(checkpoint.state), bits_of(state));
        const JamResult resumed = jam_packing(scene, checkpoint.state);
        EXPECT_EQ(checkpoint.state.step, whole.step);
        EXPECT_EQ(bits_of(checkpoint.state), bits_of(whole)) << "stopped at " << stop_at;
        EXPECT_EQ(resumed.outcome, expected.outcome);
        for (std::size_t k = 0; k < expected.verdict.criteria.size(); ++k) {
            const double value = expected.verdict.criteria[k].value;
            if (std::isnan(value)) continue;
            EXPECT_EQ(resumed.verdict.criteria[k].value, value);
        }
    }
}

TEST_F(JamPackingResume, TakesThePreviousCheckpointWhereTheLastIsDamaged) {
    Scene scene = quick_scene();
    JamState state = start_state(scene);
    state.step = 1;
    save_checkpoint(state, "scene", file());
    state.step = 2;
    save_checkpoint(state, "scene", file());
    EXPECT_EQ(load_checkpoint(file()).state.step, 2);
    std::filesystem::resize_file(file(), 1000);
    EXPECT_EQ(load_checkpoint(file()).state.step, 1);
    std::filesystem::remove(file().string() + ".previous");
    EXPECT_THROW(load_checkpoint(file()), FileError);
}

TEST(JamPacking, CatchesATimeStepBeyondTheStabilityLimit) {
    Scene scene = quick_scene();
    scene.protocol.time_step = 5.0;
    JamState state = start_state(scene);
    try {
        jam_packing(scene, state);
        FAIL() << "an unstable time step went unnoticed";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("protocol.time_step"), std::string::npos);
    }
}

TEST(JamPacking, StopsAtItsLimitWithTheVerdictOfThatState) {
    Scene scene = quick_scene();
    scene.stop.max_steps = 120;
    JamState state = start_state(scene);
    const JamResult result = jam_packing(scene, state);
    EXPECT_EQ(result.outcome, JamOutcome::step_limit);
    EXPECT_EQ(state.step, 120);
    EXPECT_FALSE(result.verdict.converged());
    EXPECT_NE(result.measurement.packing.provenance.verdict.find("\"converged\":false"),
              std::string::npos);
}

}  // namespace
}  // namespace jam
