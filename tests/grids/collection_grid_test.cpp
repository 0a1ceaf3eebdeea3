// SPDX-License-Identifier: BSD-3-Clause
#include "grids/collection_grid.h"

#include <gtest/gtest.h>

#include <set>

namespace jam {
namespace {

TEST(CollectionGrid, CurveVisitsEveryBinOnce) {
    for (const Eigen::Array3i& bins :
         {Eigen::Array3i(1, 1, 1), Eigen::Array3i(5, 3, 7), Eigen::Array3i(1, 100, 2)}) {
        CollectionGrid grid;
        set_bins(grid, bins);
        ASSERT_EQ(grid.bin_count(), bins.prod());
        std::set<Index> seen;
        for (int z = 0; z < bins[2]; ++z)
            for (int y = 0; y < bins[1]; ++y)
                for (int x = 0; x < bins[0]; ++x) {
                    const Index bin = grid.bin_at(x, y, z);
                    EXPECT_TRUE((grid.coordinates(bin) == Eigen::Array3i(x, y, z)).all());
                    seen.insert(bin);
                }
        EXPECT_EQ(static_cast<Index>(seen.size()), grid.bin_count());
    }
}

TEST(CollectionGrid, CurveKeepsBlocksOfEightTogether) {
    CollectionGrid grid;
    set_bins(grid, {4, 4, 4});
    std::set<Index> corner;
    for (int k = 0; k < 8; ++k) corner.insert(grid.bin_at(k & 1, k >> 1 & 1, k >> 2));
    EXPECT_EQ(corner, (std::set<Index>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(CollectionGrid, BinsAreWideEnoughAndFewEnough) {
    Mat3 h;
    h << 30.0, 10.0, -12.0, 0.0, 40.0, 15.0, 0.0, 0.0, 25.0;
    const PeriodicCell cell(h);
    const Eigen::Array3i bins = bins_along_edges(cell, 3.0, 100000);
    for (int k = 0; k < 3; ++k) EXPECT_GE(cell.perpendicular_widths()[k] / bins[k], 3.0);
    // Memory follows the particles: a nearly empty cell has few bins however fine they could be.
    EXPECT_LE(bins_along_edges(PeriodicCell::cubic(1e6), 1.0, 10).prod(), 20);
    EXPECT_TRUE((bins_along_edges(PeriodicCell::cubic(1.0), 3.0, 10) == 1).all());
}

TEST(CollectionGrid, EveryPointHasABin) {
    CollectionGrid grid;
    set_bins(grid, {3, 3, 3});
    EXPECT_EQ(bin_of(grid, {0.0, 0.0, 0.0}), grid.bin_at(0, 0, 0));
    EXPECT_EQ(bin_of(grid, Vec3::Constant(std::nextafter(1.0, 0.0))), grid.bin_at(2, 2, 2));
    EXPECT_EQ(bin_of(grid, {0.4, 0.1, 0.9}), grid.bin_at(1, 0, 2));
}

}  // namespace
}  // namespace jam
