// SPDX-License-Identifier: BSD-3-Clause
#include "core/lanes.h"

#include <gtest/gtest.h>

#include <vector>

namespace jam {
namespace {

TEST(Lanes, TransposedTwiceIsTheSame) {
    const Columns4 rows = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}};
    const Columns4 columns = transposed(rows);
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(columns.x[k], 4 * k);
        EXPECT_EQ(columns.y[k], 4 * k + 1);
        EXPECT_EQ(columns.z[k], 4 * k + 2);
        EXPECT_EQ(columns.w[k], 4 * k + 3);
    }
    const Columns4 again = transposed(columns);
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(again.x[k], rows.x[k]);
        EXPECT_EQ(again.w[k], rows.w[k]);
    }
}

TEST(Lanes, TheFourthComesFromTheOther) {
    const Double4 mixed = with_fourth_of(Double4{1, 2, 3, 4}, Double4{5, 6, 7, 8});
    EXPECT_EQ(mixed[0], 1);
    EXPECT_EQ(mixed[1], 2);
    EXPECT_EQ(mixed[2], 3);
    EXPECT_EQ(mixed[3], 8);
}

TEST(Lanes, GivesOneBitForEachThatIsTrue) {
    for (unsigned bits = 0; bits < 16; ++bits) {
        Double4 wanted{};
        for (int k = 0; k < 4; ++k) wanted[k] = (bits >> k & 1u) != 0 ? 1.0 : 0.0;
        EXPECT_EQ(bits_of(wanted > Double4{}), bits);
    }
}

TEST(Lanes, GivesOneBitForEachOfEightThatIsTrue) {
    for (std::uint32_t bits = 0; bits < 256; ++bits) {
        Float8 wanted{};
        for (int k = 0; k < 8; ++k) wanted[k] = (bits >> k & 1u) != 0 ? 1.0f : 0.0f;
        EXPECT_EQ(bits_of_eight(wanted > Float8{}), bits);
    }
}

TEST(Lanes, PacksThoseThatAreWanted) {
    const std::vector<std::int32_t> records = {10, 11, 12, 13};
    for (unsigned bits = 0; bits < 16; ++bits) {
        std::vector<std::int32_t> expected;
        for (unsigned k = 0; k < 4; ++k)
            if ((bits >> k & 1u) != 0) expected.push_back(records[k]);
        std::vector<std::int32_t> packed(4, -1);
        packed.resize(store_packed(records.data(), bits, packed.data()));
        EXPECT_EQ(packed, expected) << "bits " << bits;
    }
}

TEST(Lanes, PacksThoseOfSixteenThatAreWanted) {
    std::vector<float> numbers;
    std::vector<std::uint32_t> words;
    for (std::uint32_t k = 0; k < lane_count; ++k) {
        numbers.push_back(100.0f + static_cast<float>(k));
        words.push_back(200 + k);
    }
    for (std::uint32_t bits : {0u, 1u, 0x8000u, 0x00ffu, 0xff00u, 0x1234u, 0xa5c3u, 0xffffu}) {
        std::vector<float> expected_numbers;
        std::vector<std::uint32_t> expected_words;
        for (std::size_t k = 0; k < lane_count; ++k) {
            if ((bits >> k & 1u) == 0) continue;
            expected_numbers.push_back(numbers[k]);
            expected_words.push_back(words[k]);
        }
        std::vector<float> packed_numbers(lane_count);
        std::vector<std::uint32_t> packed_words(lane_count);
        packed_numbers.resize(
            store_packed(load_lanes(numbers.data()), bits, packed_numbers.data()));
        packed_words.resize(store_packed(load_lanes(words.data()), bits, packed_words.data()));
        EXPECT_EQ(packed_numbers, expected_numbers) << "bits " << bits;
        EXPECT_EQ(packed_words, expected_words) << "bits " << bits;
    }
}

TEST(Lanes, StoresFourInOrder) {
    std::vector<double> stored(5, -1.0);
    store_lanes(Double4{10, 11, 12, 13}, stored.data());
    EXPECT_EQ(stored, (std::vector<double>{10, 11, 12, 13, -1}));
}

TEST(Lanes, SquaresLengthsWithoutTheFourthColumn) {
    const Columns4 v = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
    const Double4 squared = squared_length(v);
    for (int k = 0; k < 4; ++k)
        EXPECT_EQ(squared[k], (k + 1) * (k + 1) + (k + 5) * (k + 5) + (k + 9) * (k + 9));
}

TEST(Lanes, FoursCoverEveryRecordOnceAndInOrder) {
    for (int size = 0; size < 13; ++size) {
        std::vector<int> records;
        for (int k = 0; k < size; ++k) records.push_back(100 + k);
        std::vector<int> met;
        for_each_four(std::span<const int>(records), [&](const int* four, int count) {
            for (int k = 0; k < 4; ++k) {
                if ((bits_of_first(count) >> k & 1u) != 0)
                    met.push_back(four[k]);
                else
                    EXPECT_EQ(four[k], four[0]) << "a place beyond the end";
            }
        });
        EXPECT_EQ(met, records);
    }
}

}  // namespace
}  // namespace jam
