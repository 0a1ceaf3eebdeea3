// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/brute_force_neighbors.h"

#include "core/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(BruteForceNeighbors, FindsThePairAcrossTheFace) {
    const std::vector<Sphere> spheres = {{{0.05, 0.5, 0.5}, 1.0}, {{0.95, 0.5, 0.5}, 1.0}};
    const NearPair across{0, 1, Image(-1, 0, 0)};
    EXPECT_THAT(brute_force_neighbors(PeriodicCell::cubic(9.0), spheres), ElementsAre(across));
    EXPECT_THAT(brute_force_neighbors(PeriodicCell::cubic(10.5), spheres), IsEmpty());
}

TEST(BruteForceNeighbors, ReachGrowsByStrainMarginAndTwoSkins) {
    // The two stand 1.2 apart.
    const std::vector<Sphere> spheres = {{{0.2, 0.5, 0.5}, 1.0}, {{0.32, 0.5, 0.5}, 1.0}};
    const PeriodicCell cell = PeriodicCell::cubic(10.0);
    EXPECT_THAT(brute_force_neighbors(cell, spheres, 0.19, 0.0), IsEmpty());
    EXPECT_THAT(brute_force_neighbors(cell, spheres, 0.21, 0.0).size(), 1u);
    EXPECT_THAT(brute_force_neighbors(cell, spheres, 0.0, 0.099), IsEmpty());
    EXPECT_THAT(brute_force_neighbors(cell, spheres, 0.0, 0.101).size(), 1u);
}

TEST(BruteForceNeighbors, OnePairThroughSeveralImages) {
    // Half a cell apart along a: near on both sides; each sphere also near its own image along b.
    const PeriodicCell cell(Vec3(1.9, 1.05, 1.5).asDiagonal());
    const std::vector<Sphere> spheres = {{{0.0, 0.0, 0.0}, 1.0}, {{0.5, 0.0, 0.0}, 1.0}};
    EXPECT_THAT(brute_force_neighbors(cell, spheres, 0.05, 0.0),
                ElementsAre(NearPair{0, 0, Image(0, 1, 0)}, NearPair{0, 1, Image(-1, 0, 0)},
                            NearPair{0, 1, Image(0, 0, 0)}, NearPair{1, 1, Image(0, 1, 0)}));
}

TEST(BruteForceNeighbors, SeesTheTilt) {
    Mat3 edges = Mat3::Identity() * 4.0;
    edges(0, 1) = 2.0;
    const std::vector<Sphere> near_if_tilted = {{{0.5, 0.7, 0.5}, 1.0}, {{0.7, 0.5, 0.5}, 1.0}};
    EXPECT_EQ(brute_force_neighbors(PeriodicCell(edges), near_if_tilted).size(), 1u);
    EXPECT_THAT(brute_force_neighbors(PeriodicCell::cubic(4.0), near_if_tilted), IsEmpty());
    const std::vector<Sphere> near_if_cubic = {{{0.62, 0.7, 0.5}, 1.0}, {{0.5, 0.5, 0.5}, 1.0}};
    EXPECT_THAT(brute_force_neighbors(PeriodicCell(edges), near_if_cubic), IsEmpty());
    EXPECT_EQ(brute_force_neighbors(PeriodicCell::cubic(4.0), near_if_cubic).size(), 1u);
}

TEST(BruteForceNeighbors, RefusesACellThatNeedsMoreImages) {
    const std::vector<Sphere> spheres = {{{0.5, 0.5, 0.5}, 2.0}};
    EXPECT_THROW(brute_force_neighbors(PeriodicCell::cubic(1.9), spheres), InputError);
    EXPECT_THROW(brute_force_neighbors(PeriodicCell::cubic(2.1), spheres, 0.1), InputError);
}

TEST(BruteForceNeighbors, BringsAnyListToOneForm) {
    NeighborList list;
    list.row_begin = {0, 1, 3};
    list.neighbors = {Neighbor(0, image_code(0, -1, 1)), Neighbor(0, image_code(1, 0, 0)),
                      Neighbor(0, home_image)};
    EXPECT_THAT(canonical_pairs(list),
                ElementsAre(NearPair{0, 0, Image(0, 1, -1)}, NearPair{0, 1, Image(-1, 0, 0)},
                            NearPair{0, 1, Image(0, 0, 0)}));
}

}  // namespace
}  // namespace jam
