// SPDX-License-Identifier: BSD-3-Clause
#include "core/check.h"
#include "sizes/size_distribution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace jam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string complaint(const SizeDistribution& sizes) {
    try {
        check(sizes);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SizeDistributionCheck, AcceptsTheDefaultsAndTheEndsOfTheRanges) {
    for (const SizeDistribution& sizes :
         {SizeDistribution{PowerLaw{}}, SizeDistribution{Binary{}},
          SizeDistribution{Monodisperse{}}, SizeDistribution{GrainSizeDistribution{}},
          SizeDistribution{Lognormal{}}, SizeDistribution{PowerLaw{1.0, min_alpha}},
          SizeDistribution{PowerLaw{1e5, max_alpha}}, SizeDistribution{Lognormal{1.5}},
          SizeDistribution{Lognormal{0.01}}})
        EXPECT_EQ(complaint(sizes), "");
}

TEST(SizeDistributionCheck, NamesKeyValueAndRule) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(complaint(PowerLaw{0.5, 1.0}),
                StartsWith("sizes.size_ratio = 0.5: must be from 1"));
    EXPECT_THAT(complaint(PowerLaw{nan, 1.0}), StartsWith("sizes.size_ratio = nan"));
    EXPECT_THAT(complaint(PowerLaw{5.0, 4.5}), StartsWith("sizes.alpha = 4.5 (sizes.beta = -0.5)"));
    EXPECT_THAT(complaint(PowerLaw{5.0, nan}), StartsWith("sizes.alpha = nan"));
    EXPECT_THAT(complaint(Binary{2e5, 0.5, 1}), StartsWith("sizes.size_ratio = 200000"));
    EXPECT_THAT(complaint(Binary{5.0, 1.0, 1}), StartsWith("sizes.small_fraction = 1:"));
    EXPECT_THAT(complaint(Binary{5.0, 0.0, 1}), HasSubstr("monodisperse"));
    EXPECT_THAT(complaint(Binary{5.0, 0.5, 0}), StartsWith("sizes.large_count = 0:"));
    EXPECT_THAT(complaint(GrainSizeDistribution{5.0, 0.0}), StartsWith("sizes.eta = 0:"));
    EXPECT_THAT(complaint(GrainSizeDistribution{0.0, 0.5}), StartsWith("sizes.size_ratio = 0:"));
    EXPECT_THAT(complaint(Lognormal{2.0}), StartsWith("sizes.sigma = 2:"));
    EXPECT_THAT(complaint(Lognormal{0.2, 1.0}), StartsWith("sizes.size_ratio = 1:"));
    EXPECT_THAT(complaint(DiameterList{}), StartsWith("sizes.file"));
    EXPECT_THAT(complaint(CumulativeCurve{}), StartsWith("sizes.file"));
}

TEST(SizeDistributionCheck, KindsHaveTheNamesOfTheScene) {
    EXPECT_EQ(kind_name(PowerLaw{}), "power-law");
    EXPECT_EQ(kind_name(Binary{}), "binary");
    EXPECT_EQ(kind_name(Monodisperse{}), "monodisperse");
    EXPECT_EQ(kind_name(GrainSizeDistribution{}), "grain-size-distribution");
    EXPECT_EQ(kind_name(Lognormal{}), "lognormal");
    EXPECT_EQ(kind_name(DiameterList{}), "table");
    EXPECT_EQ(kind_name(CumulativeCurve{}), "table");
}

}  // namespace
}  // namespace jam
