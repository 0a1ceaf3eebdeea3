// SPDX-License-Identifier: BSD-3-Clause
#include "grids/size_collections.h"

#include "core/check.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

std::vector<double> spread(double size_ratio, int count) {
    std::vector<double> diameters;
    for (int i = 0; i < count; ++i)
        diameters.push_back(std::pow(size_ratio, double(i) / (count - 1)));
    return diameters;
}

TEST(SizeCollections, MonodisperseIsOneCollection) {
    const SizeCollections collections = geometric_collections(std::vector<double>(7, 2.5));
    ASSERT_EQ(collections.count(), 1);
    EXPECT_EQ(collections.upper[0], 2.5);
    EXPECT_EQ(collections.begin, (std::vector<Index>{0, 7}));
}

TEST(SizeCollections, EveryParticleIsInTheIntervalOfItsCollection) {
    for (const double size_ratio : {2.0, 10.0, 100.0, 1000.0}) {
        const std::vector<double> diameters = spread(size_ratio, 1000);
        const SizeCollections collections = geometric_collections(diameters, {.ratio = 4.0});
        EXPECT_EQ(collections.count(),
                  std::max(1, static_cast<int>(std::round(std::log(size_ratio) / std::log(4.0)))));
        EXPECT_EQ(collections.upper.back(), diameters.back());
        std::vector<Index> members(static_cast<std::size_t>(collections.count()), 0);
        for (const double diameter : diameters) {
            const auto c = static_cast<std::size_t>(collection_of(collections, diameter));
            ASSERT_LT(c, members.size());
            EXPECT_LE(diameter, collections.upper[c]);
            EXPECT_TRUE(c == 0 || diameter > collections.upper[c - 1]);
            ++members[c];
        }
        for (std::size_t c = 0; c < members.size(); ++c)
            EXPECT_EQ(members[c], collections.begin[c + 1] - collections.begin[c]);
    }
}

TEST(SizeCollections, EmptyIntervalsAreLeftOut) {
    std::vector<double> binary(100, 1.0);
    binary.push_back(300.0);
    const SizeCollections collections = geometric_collections(binary);
    ASSERT_EQ(collections.count(), 2);
    EXPECT_EQ(collections.upper, (std::vector<double>{1.0, 300.0}));
}

TEST(SizeCollections, LinearStepsAreEqual) {
    const SizeCollections collections = linear_collections(spread(11.0, 5000), 5);
    ASSERT_EQ(collections.count(), 5);
    for (int c = 0; c < 5; ++c)
        EXPECT_NEAR(collections.upper[static_cast<std::size_t>(c)], 1.0 + 2.0 * (c + 1), 0.01);
}

TEST(SizeCollections, RefusesImpossibleSettings) {
    EXPECT_THROW(geometric_collections({}), InputError);
    EXPECT_THROW(geometric_collections(spread(5.0, 3), {.ratio = 1.0}), InputError);
    EXPECT_THROW(linear_collections(spread(5.0, 3), 0), InputError);
}

}  // namespace
}  // namespace jam
