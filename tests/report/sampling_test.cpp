// SPDX-License-Identifier: BSD-3-Clause
#include "report/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace jam {
namespace {

TEST(Sampling, SixteenPointsFillEveryGridOfSixteenCells) {
    for (std::uint64_t pixel = 0; pixel < 20; ++pixel)
        for (const SampleUse use : {SampleUse::pixel, SampleUse::sky, SampleUse::lamp})
            for (const int columns : {1, 2, 4, 8, 16}) {
                const PixelSamples samples(pixel);
                std::set<int> cells;
                for (std::uint32_t n = 0; n < 16; ++n) {
                    const auto [u, v] = samples.point(use, n);
                    ASSERT_TRUE(u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0);
                    const int rows = 16 / columns;
                    cells.insert(static_cast<int>(u * columns) * rows + static_cast<int>(v * rows));
                }
                EXPECT_EQ(cells.size(), 16u) << "pixel " << pixel << ", columns " << columns;
            }
}

TEST(Sampling, PixelsAndUsesDiffer) {
    std::set<double> values;
    for (std::uint64_t pixel : {0ull, 1ull, 1600ull})
        for (const SampleUse use : {SampleUse::pixel, SampleUse::sky, SampleUse::lamp})
            values.insert(PixelSamples(pixel).point(use, 0)[0]);
    EXPECT_EQ(values.size(), 9u);
}

TEST(Sampling, CosineDirectionsHaveTheMeanOfACosineLaw) {
    constexpr std::uint32_t count = 4096;
    for (const Vec3& normal : {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0), Vec3(0.6, 0.0, -0.8)}) {
        Vec3 sum = Vec3::Zero();
        for (std::uint32_t n = 0; n < count; ++n) {
            const Vec3 direction =
                cosine_direction(PixelSamples(3).point(SampleUse::sky, n), normal);
            EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
            EXPECT_GE(direction.dot(normal), 0.0);
            sum += direction;
        }
        EXPECT_LT((sum / count - 2.0 / 3.0 * normal).norm(), 2e-3);
    }
}

TEST(Sampling, CapDirectionsFillTheCap) {
    const Vec3 axis = Vec3(1.0, 2.0, -2.0) / 3.0;
    double smallest = 1.0;
    double sum = 0.0;
    constexpr std::uint32_t count = 4096;
    for (std::uint32_t n = 0; n < count; ++n) {
        const Vec3 direction = cap_direction(PixelSamples(9).point(SampleUse::lamp, n), axis, 0.9);
        EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
        smallest = std::min(smallest, direction.dot(axis));
        sum += direction.dot(axis);
    }
    EXPECT_NEAR(smallest, 0.9, 1e-3);
    EXPECT_GE(smallest, 0.9 - 1e-12);
    EXPECT_NEAR(sum / count, 0.95, 1e-3);
}

}  // namespace
}  // namespace jam
