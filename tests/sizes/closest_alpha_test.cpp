// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/closest_alpha.h"

#include "core/check.h"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(ClosestAlpha, IsOneWhereTheTwoFamiliesMeet) {
    for (const double size_ratio : {5.0, 32.0, 1000.0})
        EXPECT_NEAR(closest_alpha(1.0, size_ratio), 1.0, 1e-5);
}

// Monti et al. compare by eye at lambda 32: eta 0.8 with alpha 0.75, 0.6 with 0.5, and find that
// 0.4 "bears some resemblance" to 0.2, and that the families scale alike at large D.
TEST(ClosestAlpha, AgreesWithThePapersComparisonAtLargeDiameters) {
    EXPECT_NEAR(closest_alpha(0.8, 32.0, 0.5), 0.75, 0.02);
    EXPECT_NEAR(closest_alpha(0.6, 32.0, 0.5), 0.50, 0.02);
    EXPECT_NEAR(closest_alpha(0.4, 32.0, 0.5), 0.20, 0.02);
    EXPECT_NEAR(closest_alpha(0.3, 32.0, 0.5), 0.00, 0.02);
}

TEST(ClosestAlpha, IsLowerOverAllDiameters) {
    EXPECT_NEAR(closest_alpha(0.8, 32.0), 0.75, 0.01);
    EXPECT_NEAR(closest_alpha(0.6, 32.0), 0.47, 0.01);
    EXPECT_NEAR(closest_alpha(0.4, 32.0), 0.11, 0.01);
    EXPECT_NEAR(closest_alpha(0.3, 32.0), -0.12, 0.01);
}

TEST(ClosestAlpha, IsBelowEtaAndRisesWithIt) {
    double before = -10.0;
    for (const double eta : {0.3, 0.5, 0.7, 0.9}) {
        const double alpha = closest_alpha(eta, 20.0);
        EXPECT_LT(alpha, eta);
        EXPECT_GT(alpha, before);
        before = alpha;
    }
}

TEST(ClosestAlpha, RefusesWhatCannotBeCompared) {
    EXPECT_THROW(closest_alpha(0.0, 10.0), InputError);
    EXPECT_THROW(closest_alpha(0.5, 1.0), InputError);
    EXPECT_THROW(closest_alpha(0.5, 10.0, 1.0), InputError);
}

}  // namespace
}  // namespace jam
