// SPDX-License-Identifier: BSD-3-Clause
#include "cell/periodic_cell.h"

#include "core/check.h"
#include "core/random.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace jam {
namespace {

Mat3 tilted() {
    Mat3 h;
    h << 4.0, 1.5, -1.8, 0.0, 5.0, 2.2, 0.0, 0.0, 6.0;
    return h;
}

TEST(PeriodicCell, FractionalAndCartesianAreInverse) {
    const PeriodicCell cell(tilted());
    const Vec3 s(0.3, -1.7, 2.4);
    EXPECT_LT((cell.fractional(cell.cartesian(s)) - s).norm(), 1e-14);
    EXPECT_DOUBLE_EQ(cell.volume(), 120.0);
    EXPECT_LT((cell.matrix() * cell.inverse() - Mat3::Identity()).norm(), 1e-14);
}

TEST(PeriodicCell, WidthsAreVolumeOverFaceArea) {
    const PeriodicCell cell(tilted());
    const Vec3 a = tilted().col(0);
    const Vec3 b = tilted().col(1);
    const Vec3 c = tilted().col(2);
    const Vec3 expected(120.0 / b.cross(c).norm(), 120.0 / c.cross(a).norm(),
                        120.0 / a.cross(b).norm());
    EXPECT_LT((cell.perpendicular_widths() - expected).norm(), 1e-13);
}

TEST(PeriodicCell, ReductionKeepsTheLatticeAndEveryPoint) {
    Mat3 h = tilted();
    h(0, 1) = 9.3;
    h(0, 2) = -13.1;
    h(1, 2) = 8.7;
    const PeriodicCell cell(h);
    EXPECT_FALSE(cell.is_reduced());
    const PeriodicCell::Reduction reduction = cell.reduced();
    EXPECT_TRUE(reduction.cell.is_reduced());
    EXPECT_DOUBLE_EQ(reduction.cell.volume(), cell.volume());
    EXPECT_EQ(reduction.change, reduction.change.array().round().matrix());
    EXPECT_NEAR(reduction.change.determinant(), 1.0, 1e-12);
    const Vec3 s(0.21, 0.83, 0.47);
    const Vec3 same = reduction.cell.cartesian(reduction.change * s);
    EXPECT_LT((same - cell.cartesian(s)).norm(), 1e-13);
}

TEST(PeriodicCell, WrappedLiesInTheFirstImage) {
    for (const double x : {0.0, 1.0, -1.0, 0.25, -0.25, 17.75, -1e-300, 1.0 - 1e-17}) {
        const Vec3 s = wrapped({x, x, x});
        EXPECT_GE(s[0], 0.0);
        EXPECT_LT(s[0], 1.0);
        const double images = x - s[0];
        EXPECT_NEAR(images, std::round(images), 1e-15);
    }
}

TEST(PeriodicCell, WorstShorteningBoundsEveryDirection) {
    const PeriodicCell before(tilted());
    Mat3 h = tilted() * 0.97;
    h(0, 1) += 0.2;
    h(1, 2) -= 0.1;
    const PeriodicCell after(h);
    const double worst = worst_shortening(before, after);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint64_t id = 0; id < 20000; ++id) {
        const Vec3 s(uniform(1, RandomStream::tests, id, 0) - 0.5,
                     uniform(1, RandomStream::tests, id, 1) - 0.5,
                     uniform(1, RandomStream::tests, id, 2) - 0.5);
        least = std::min(least, after.cartesian(s).norm() / before.cartesian(s).norm());
    }
    EXPECT_LE(worst, least);
    EXPECT_NEAR(worst, least, 1e-3);
    EXPECT_DOUBLE_EQ(worst_shortening(before, before), 1.0);
}

TEST(PeriodicCell, RefusesWhatIsNoCell) {
    Mat3 lower = tilted();
    lower(1, 0) = 0.1;
    Mat3 flat = tilted();
    flat(2, 2) = 0.0;
    Mat3 broken = tilted();
    broken(0, 1) = std::numeric_limits<double>::quiet_NaN();
    for (const Mat3& h : {lower, flat, broken}) EXPECT_THROW(PeriodicCell{h}, InputError);
}

}  // namespace
}  // namespace jam
