// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>

namespace jam {
namespace {

TEST(Parallel, BlocksCoverEveryItemOnce) {
    for (const Count count : {0, 1, 99, 100, 101, 1000}) {
        std::vector<int> visits(static_cast<std::size_t>(count), 0);
        for_each_block(count, 100, [&](Count block, Count begin, Count end) {
            EXPECT_EQ(begin, block * 100);
            for (Count i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
        });
        EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), count);
    }
}

TEST(Parallel, SumsHaveTheSameBitsForAnyThreadCount) {
    const auto sum_with = [](int threads) {
        return run_with_threads(threads, [] {
            return sum_blocks(100000, 128, 0.0, [](Count begin, Count end) {
                double sum = 0.0;
                for (Count i = begin; i < end; ++i)
                    sum += uniform(3, RandomStream::tests, static_cast<std::uint64_t>(i));
                return sum;
            });
        });
    };
    const double alone = sum_with(1);
    EXPECT_NEAR(alone / 100000, 0.5, 0.01);
    for (const int threads : {2, 3, 5, 8, 16}) EXPECT_EQ(sum_with(threads), alone);
}

TEST(Parallel, CountingSortIsStableAndComplete) {
    for (const int threads : {1, 3}) {
        run_with_threads(threads, [] {
            constexpr Index count = 300000;  // several chunks
            constexpr Index keys = 37;
            std::vector<Index> key(count);
            for (Index i = 0; i < count; ++i)
                key[static_cast<std::size_t>(i)] = static_cast<Index>(
                    random_bits(5, RandomStream::tests, static_cast<std::uint64_t>(i)) % keys);
            std::vector<Index> begin;
            std::vector<Index> order(count);
            counting_sort(key, keys, begin, order);

            std::vector<Index> expected(count);
            std::iota(expected.begin(), expected.end(), 0);
            std::stable_sort(expected.begin(), expected.end(), [&](Index a, Index b) {
                return key[static_cast<std::size_t>(a)] < key[static_cast<std::size_t>(b)];
            });
            EXPECT_EQ(order, expected);
            ASSERT_EQ(begin.size(), std::size_t{keys} + 1);
            EXPECT_EQ(begin.back(), count);
            for (Index k = 0; k < keys; ++k)
                EXPECT_EQ(key[static_cast<std::size_t>(
                              order[static_cast<std::size_t>(begin[static_cast<std::size_t>(k)])])],
                          k);
        });
    }
}

TEST(Parallel, TasksWaitForTheirPrerequisites) {
    run_with_threads(4, [] {
        std::atomic<int> done{0};
        std::vector<int> seen(3, -1);
        TaskGraph graph;
        const auto first = graph.add([&] { ++done; });
        const auto second = graph.add([&] { ++done; });
        const auto third = graph.add([&] { seen[0] = done.exchange(2); }, {first, second});
        graph.add([&] { seen[1] = ++done; }, {third});
        graph.run();
        EXPECT_EQ(seen[0], 2);
        EXPECT_EQ(seen[1], 3);
    });
}

TEST(Parallel, AnExceptionOfATaskReachesTheCaller) {
    TaskGraph graph;
    graph.add([] { throw std::runtime_error("from a task"); });
    EXPECT_THROW(graph.run(), std::runtime_error);
}

}  // namespace
}  // namespace jam
