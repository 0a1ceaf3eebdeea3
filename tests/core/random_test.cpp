// SPDX-License-Identifier: BSD-3-Clause
#include "core/random.h"

#include <gtest/gtest.h>

#include <set>

namespace jam {
namespace {

TEST(Random, UniformStaysInsideAndFillsTheInterval) {
    double sum = 0.0;
    double sum_of_squares = 0.0;
    constexpr int count = 100000;
    for (int id = 0; id < count; ++id) {
        const double u = uniform(7, RandomStream::tests, static_cast<std::uint64_t>(id));
        ASSERT_GT(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        sum_of_squares += u * u;
    }
    EXPECT_NEAR(sum / count, 1.0 / 2.0, 0.004);
    EXPECT_NEAR(sum_of_squares / count, 1.0 / 3.0, 0.004);
}

TEST(Random, EveryKeyMatters) {
    std::set<std::uint64_t> bits;
    for (std::uint64_t seed : {1ull, 2ull, 1ull << 40})
        for (RandomStream stream : {RandomStream::tests, RandomStream::rods})
            for (std::uint64_t id : {0ull, 1ull, 1ull << 40})
                for (std::uint32_t draw : {0u, 1u})
                    bits.insert(random_bits(seed, stream, id, draw));
    EXPECT_EQ(bits.size(), 3u * 2u * 3u * 2u);
}

}  // namespace
}  // namespace jam
