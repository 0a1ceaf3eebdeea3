// SPDX-License-Identifier: BSD-3-Clause
#include "cell/upper_map.h"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(UpperMap, IsTheMatrixForOneVectorAndForFour) {
    Mat3 matrix;
    matrix << 1.1, 0.3, -0.7, 0.0, 0.9, 0.2, 0.0, 0.0, 1.3;
    const UpperMap map(matrix);
    const Columns4 rows = {
        {0.1, 0.2, 0.3, 5.0}, {-0.4, 0.5, 0.6, 6.0}, {0.7, -0.8, 0.9, 7.0}, {1.0, 1.1, -1.2, 8.0}};
    const Columns4 together = transposed(map(transposed(rows)));
    for (const auto& [vector, mapped] :
         {std::pair(rows.x, together.x), std::pair(rows.y, together.y),
          std::pair(rows.z, together.z), std::pair(rows.w, together.w)}) {
        const Double4 alone = map(vector);
        const Vec3 expected = matrix * Vec3(vector[0], vector[1], vector[2]);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(alone[k], expected[k], 1e-15);
            EXPECT_EQ(mapped[k], alone[k]) << "not the same bits";
        }
        EXPECT_EQ(alone[3], 0.0);
        EXPECT_EQ(mapped[3], 0.0);
    }
}

}  // namespace
}  // namespace jam
