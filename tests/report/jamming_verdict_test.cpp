// SPDX-License-Identifier: BSD-3-Clause
#include "report/jamming_verdict.h"

#include "support/packings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jam {
namespace {

using namespace test;
using testing::HasSubstr;

JammingVerdict verdict_of(const Packing& packing) {
    return judge(measure(packing, find_force_network(packing)));
}

TEST(JammingVerdict, APressedCrystalIsJammed) {
    const JammingVerdict verdict = verdict_of(face_centered_cubic(3, 1.41, 1.0));
    EXPECT_TRUE(verdict.jammed());
    EXPECT_THAT(verdict.sentence(), HasSubstr("Jammed"));
}

TEST(JammingVerdict, EachCriterionCanFailAlone) {
    const Packing good = face_centered_cubic(3, 1.41, 1.0);
    Packing moving = good;
    moving.velocities.assign(moving.positions.size(), Vec3(1e-3, 0.0, 0.0));
    Packing pushed = good;
    pushed.positions[0] += Vec3(1e-4, 0.0, 0.0);
    Packing under_load = good;
    under_load.applied_pressure = Mat3::Identity() * 7.0;
    const auto failing = [](const Packing& packing) {
        std::vector<bool> fails;
        for (const JammingCriterion& criterion : verdict_of(packing).criteria)
            fails.push_back(!criterion.holds);
        return fails;
    };
    EXPECT_EQ(failing(good), (std::vector<bool>{false, false, false, false}));
    EXPECT_EQ(failing(moving), (std::vector<bool>{false, false, false, true}));
    EXPECT_EQ(failing(pushed), (std::vector<bool>{false, true, false, false}));
    EXPECT_EQ(failing(under_load), (std::vector<bool>{false, false, true, false}));
    EXPECT_THAT(verdict_of(pushed).sentence(), HasSubstr("1 of 4 criteria does not hold"));
}

TEST(JammingVerdict, WhereStabilityIsKnownItCounts) {
    const Packing crystal = face_centered_cubic(3, 1.41, 1.0);
    const ForceNetwork network = find_force_network(crystal);
    Measurements measurements = measure(crystal, network);
    measurements.elasticity = find_elasticity(crystal, network);
    ASSERT_EQ(judge(measurements).criteria.size(), 5u);
    EXPECT_TRUE(judge(measurements).jammed());
    measurements.elasticity->stability.stable = false;
    EXPECT_FALSE(judge(measurements).jammed());
    EXPECT_FALSE(judge(measurements).criteria.back().holds);
}

TEST(JammingVerdict, WithoutContactsNothingHoldsButRest) {
    const JammingVerdict verdict = verdict_of(face_centered_cubic(3, 1.6, 1.0));
    EXPECT_FALSE(verdict.jammed());
    EXPECT_FALSE(verdict.criteria[0].holds);
    EXPECT_FALSE(verdict.criteria[1].holds);
    EXPECT_FALSE(verdict.criteria[2].holds);
    EXPECT_THAT(verdict.criteria[0].finding, HasSubstr("no backbone"));
}

}  // namespace
}  // namespace jam
