// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/saddle_leap.h"

#include <gtest/gtest.h>

namespace jam {
namespace {

/// Three spheres in a cell of side 10, their places in the arrays not in the order of the ids. The
/// second has no contact.
class SaddleLeap : public testing::Test {
  protected:
    SaddleLeap() {
        particles_.ids = {2, 0, 1};
        particles_.spheres = {Sphere{{0.1, 0.2, 0.3}, 1.0}, Sphere{{0.5, 0.5, 0.5}, 1.0},
                              Sphere{{0.7, 0.8, 0.999}, 1.0}};
        particles_.loads.resize(3);
        particles_.loads[0].contacts = 4.0;
        particles_.loads[2].contacts = 3.0;
    }

    PeriodicCell cell_ = PeriodicCell::cubic(10.0);
    Particles particles_;
};

TEST_F(SaddleLeap, AddsToThoseInContactWhatTheyHaveGone) {
    const LeapReference before = leap_reference(particles_, 1e-6);
    EXPECT_EQ(before.cundall, 1e-6);
    particles_.spheres[0].center.x() += 1e-6;
    particles_.spheres[1].center.y() += 1e-4;
    particles_.spheres[2].center.z() += 4e-6;  // 4e-5 of length
    const std::vector<Sphere> now = particles_.spheres;
    EXPECT_NEAR(leap(before, cell_, 1e-3, particles_), 25.0, 1e-6);
    EXPECT_NEAR(particles_.spheres[0].center.x() - now[0].center.x(), 25e-6, 1e-12);
    EXPECT_EQ(particles_.spheres[1].center, now[1].center);
    EXPECT_NEAR(particles_.spheres[2].center.z() - now[2].center.z(), 1e-4, 1e-12);
    EXPECT_EQ(particles_.spheres[2].center.x(), now[2].center.x());
}

TEST_F(SaddleLeap, AddsItFiftyTimesAtMost) {
    const LeapReference before = leap_reference(particles_, 1e-6);
    particles_.spheres[0].center.x() += 1e-9;
    EXPECT_EQ(leap(before, cell_, 1e-3, particles_), 50.0);
    EXPECT_NEAR(particles_.spheres[0].center.x(), 0.1 + 51e-9, 1e-15);
}

TEST_F(SaddleLeap, FollowsTheSpheresWhereverTheyAreKeptAndAcrossTheCellsFaces) {
    const LeapReference before = leap_reference(particles_, 1e-6);
    std::swap(particles_.spheres[0], particles_.spheres[2]);
    std::swap(particles_.loads[0], particles_.loads[2]);
    std::swap(particles_.ids[0], particles_.ids[2]);
    particles_.spheres[0].center.z() = 0.004;  // 0.05 of length on
    EXPECT_NEAR(leap(before, cell_, 0.1, particles_), 2.0, 1e-9);
    EXPECT_NEAR(particles_.spheres[0].center.z(), 0.014, 1e-12);
    EXPECT_EQ(particles_.spheres[2].center, Vec3(0.1, 0.2, 0.3));
}

TEST_F(SaddleLeap, StaysWhereNobodyInContactHasMoved) {
    const LeapReference before = leap_reference(particles_, 1e-6);
    particles_.spheres[1].center.y() += 1e-4;
    const std::vector<Sphere> now = particles_.spheres;
    EXPECT_EQ(leap(before, cell_, 1e-3, particles_), 0.0);
    for (std::size_t i = 0; i < now.size(); ++i)
        EXPECT_EQ(particles_.spheres[i].center, now[i].center);
}

}  // namespace
}  // namespace jam
