// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/particle_count.h"

#include "core/check.h"
#include "sizes/size_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jam {
namespace {

// Monti et al., "Particle size distributions": lambda = 50.
TEST(ParticleCount, GivesThePapersCounts) {
    EXPECT_NEAR(static_cast<double>(particle_count(PowerLaw{50.0, 1.0})), 233653.0,
                0.0004 * 233653);
    EXPECT_NEAR(static_cast<double>(particle_count(PowerLaw{50.0, 0.2})), 3739236.0,
                0.0004 * 3739236);
}

TEST(ParticleCount, OfBinarySpheresKeepsTheVolumeFraction) {
    // 10 large ones of volume 125; three quarters as much volume again, divided among 3 : 1.
    EXPECT_EQ(particle_count(Binary{5.0, 0.75, 10}), 10 + 10 * 125 * 3);
    EXPECT_EQ(particle_count(Binary{1.0, 0.5, 7}), 14);
}

TEST(ParticleCount, OfAListIsItsLength) {
    EXPECT_EQ(particle_count(diameter_list({1.0, 2.0, 2.0})), 3);
}

TEST(ParticleCount, OfEqualSpheresMustBeGiven) {
    EXPECT_THROW(
        try { particle_count(Monodisperse{}); } catch (const InputError& error) {
            EXPECT_THAT(error.what(), testing::StartsWith("sizes.count: missing"));
            throw;
        },
        InputError);
}

TEST(ParticleCount, BeyondWhatCanBeHeldIsRefusedWithARemedy) {
    for (const SizeDistribution& sizes :
         {SizeDistribution{PowerLaw{1000.0, -0.5}}, SizeDistribution{Binary{1000.0, 0.5, 1}}})
        EXPECT_THROW(
            try { particle_count(sizes); } catch (const InputError& error) {
                EXPECT_THAT(error.what(), testing::StartsWith("sizes.count = "));
                EXPECT_THAT(error.what(), testing::HasSubstr("lower sizes."));
                throw;
            },
            InputError);
}

TEST(ParticleCount, GivenMustBePositiveAndFit) {
    EXPECT_NO_THROW(check_particle_count(1));
    EXPECT_NO_THROW(check_particle_count(max_particle_count));
    EXPECT_THROW(check_particle_count(0), InputError);
    EXPECT_THROW(check_particle_count(max_particle_count + 1), InputError);
}

}  // namespace
}  // namespace jam
