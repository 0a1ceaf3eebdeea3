// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/unheld.h"

#include "core/random.h"
#include "support/packings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace jam {
namespace {

using namespace test;

using Directions = std::vector<Vec3>;

const Directions tetrahedral = {Vec3(1, 1, 1) / std::sqrt(3.0), Vec3(1, -1, -1) / std::sqrt(3.0),
                                Vec3(-1, 1, -1) / std::sqrt(3.0), Vec3(-1, -1, 1) / std::sqrt(3.0)};

Vec3 random_direction(std::uint64_t seed, int id) {
    const auto draw = [&](std::uint32_t k) {
        return uniform(seed, RandomStream::tests, static_cast<std::uint64_t>(id), k);
    };
    const double z = 2.0 * draw(0) - 1.0;
    const double angle = 2.0 * std::numbers::pi * draw(1);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

TEST(WithinHalfSpace, ATetrahedronHoldsAndAnyThreeDoNot) {
    EXPECT_FALSE(within_half_space(tetrahedral));
    EXPECT_TRUE(within_half_space(std::span(tetrahedral).first(3)));
    EXPECT_TRUE(within_half_space({}));
}

TEST(WithinHalfSpace, FourInAPlaneDoNotHold) {
    const Directions cross = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()};
    EXPECT_TRUE(within_half_space(cross));
    Directions pressed = cross;
    pressed.push_back(Vec3::UnitZ());
    EXPECT_TRUE(within_half_space(pressed));
    pressed.push_back(-Vec3::UnitZ());
    EXPECT_FALSE(within_half_space(pressed));
}

TEST(WithinHalfSpace, AsOftenAsWendelSays) {
    // n random directions lie in one half-space with probability
    // (1 + (n - 1) + (n - 1)(n - 2) / 2) / 2^(n - 1) (Wendel, 1962).
    constexpr int trials = 4000;
    for (const int n : {4, 6, 10}) {
        int found = 0;
        for (int trial = 0; trial < trials; ++trial) {
            Directions directions;
            for (int k = 0; k < n; ++k)
                directions.push_back(
                    random_direction(static_cast<std::uint64_t>(n), trial * n + k));
            found += within_half_space(directions) ? 1 : 0;
        }
        const double expected = (1.0 + (n - 1) + (n - 1) * (n - 2) / 2.0) / std::pow(2.0, n - 1);
        const double error = std::sqrt(expected * (1.0 - expected) / trials);
        EXPECT_NEAR(found / double(trials), expected, 4.0 * error) << n;
    }
}

TEST(WithinHalfSpace, ManyDirections) {
    Directions cap;
    Directions all;
    for (int k = 0; k < 300; ++k) {
        const Vec3 direction = random_direction(1, k);
        all.push_back(direction);
        cap.push_back(direction[2] > 0.0 ? direction : Vec3(-direction));
    }
    EXPECT_FALSE(within_half_space(all));
    EXPECT_TRUE(within_half_space(cap));
    cap.push_back(Vec3(0.1, 0.2, -1.0).normalized());
    EXPECT_FALSE(within_half_space(cap));
}

Rattlers unheld_of(const Packing& packing) {
    const std::vector<Contact> contacts = find_contacts(packing);
    return find_unheld(contacts, contact_rows(static_cast<Index>(packing.size()), contacts));
}

TEST(FindUnheld, CrystalsHold) {
    EXPECT_EQ(unheld_of(simple_cubic(3, 0.99, 1.0)).rattler_count, 0);
    const Rattlers fcc = unheld_of(face_centered_cubic(2, 1.0, 0.72));
    EXPECT_EQ(fcc.rattler_count, 0);
    EXPECT_THAT(fcc.contact_counts_nr, testing::Each(12));
    EXPECT_EQ(fcc.contact_count_nr, 32 * 6);
}

TEST(FindUnheld, ASlabFallsLayerByLayer) {
    const Packing slab = cubic_slab();
    EXPECT_EQ(unheld_of(slab).rattler_count, 27);
    const std::vector<Contact> contacts = find_contacts(slab);
    EXPECT_EQ(find_rattlers(contacts, contact_rows(27, contacts), 5).rattler_count, 0);
}

TEST(FindUnheld, AtLeastThoseWithFewerThanFour) {
    const Packing packing = random_spheres(random_edges(13.5, 3), 600, 4.0, 3);
    const std::vector<Contact> contacts = find_contacts(packing);
    const ContactRows rows = contact_rows(600, contacts);
    const Rattlers few = find_rattlers(contacts, rows, 4);
    const Rattlers unheld = find_unheld(contacts, rows);
    EXPECT_GT(few.rattler_count, 0);
    EXPECT_GT(unheld.rattler_count, few.rattler_count);
    EXPECT_LT(unheld.rattler_count, 600);
    for (Index i = 0; i < 600; ++i) EXPECT_GE(unheld.is_rattler[i], few.is_rattler[i]);
}

TEST(FindUnheld, TheSameInAnyOrder) {
    const Packing packing = random_spheres(random_edges(13.5, 3), 600, 4.0, 3);
    const std::vector<Index> order = shuffled(600, 4);
    const Rattlers unheld = unheld_of(packing);
    const Rattlers retold = unheld_of(relabelled(packing, order));
    ASSERT_GT(unheld.rattler_count, 0);
    ASSERT_LT(unheld.rattler_count, 600);
    for (Index i = 0; i < 600; ++i) EXPECT_EQ(retold.is_rattler[i], unheld.is_rattler[order[i]]);
}

}  // namespace
}  // namespace jam
