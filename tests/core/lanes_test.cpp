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

TEST(Lanes, PacksThoseThatAreWanted) {
    const Double4 values = {10, 11, 12, 13};
    for (unsigned bits = 0; bits < 16; ++bits) {
        Double4 wanted{};
        std::vector<double> expected;
        for (int k = 0; k < 4; ++k) {
            if ((bits >> k & 1u) == 0) continue;
            wanted[k] = 1.0;
            expected.push_back(values[k]);
        }
        EXPECT_EQ(bits_of(wanted > Double4{}), bits);
        std::vector<double> packed(4, -1.0);
        store_packed(values, bits, packed.data());
        packed.resize(expected.size());
        EXPECT_EQ(packed, expected) << "bits " << bits;
    }
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
