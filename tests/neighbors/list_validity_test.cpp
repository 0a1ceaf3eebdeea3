// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/list_validity.h"

#include "core/random.h"
#include "neighbors/brute_force_neighbors.h"
#include "support/random_packings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace jam {
namespace {

ListReference reference_of(const test::RandomPacking& packing, const InteractionReach& reach) {
    ListReference reference{packing.cell, {}, reach};
    for (const Sphere& sphere : packing.particles.spheres)
        reference.centers.push_back(sphere.center);
    return reference;
}

TEST(ListValidity, DisplacementIsMeasuredWithinTheCell) {
    test::RandomPacking packing = test::random_packing(3, {.count = 20});
    const ListReference reference = reference_of(packing, {});
    EXPECT_EQ(largest_displacement(reference, packing.cell, packing.particles), 0.0);
    const Vec3 step(0.01, -0.02, 0.03);
    packing.particles.spheres[7].center += packing.cell.fractional(step);
    EXPECT_NEAR(largest_displacement(reference, packing.cell, packing.particles), step.norm(),
                1e-12);
}

/// As long as the test says valid, no pair that overlaps may be missing from the list, however
/// particles moved and the cell strained.
TEST(ListValidity, AValidListMissesNoContact) {
    const InteractionReach reach{0.02, 0.05};
    int valid = 0;
    int invalid = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        test::RandomPacking packing =
            test::random_packing(seed, {.count = 60, .size_ratio = 4.0, .least_width = 1.3});
        for (Sphere& sphere : packing.particles.spheres) sphere.center = wrapped(sphere.center);
        const ListReference reference = reference_of(packing, reach);
        const auto listed = brute_force_neighbors(packing.cell, packing.particles.spheres,
                                                  reach.strain_margin, reach.skin);
        const auto number = [&](std::uint64_t id) {
            return 2.0 * uniform(seed, RandomStream::tests, id, 9) - 1.0;
        };
        Mat3 strain = Mat3::Zero();
        for (int k = 0; k < 6; ++k)
            strain(k % 3, std::max(k % 3, k / 2)) += 0.012 * number(500u + k);
        const PeriodicCell now(Mat3((Mat3::Identity() + strain) * packing.cell.matrix()));
        for (std::size_t i = 0; i < packing.particles.spheres.size(); ++i)
            packing.particles.spheres[i].center +=
                now.fractional((0.025 + 0.02 * std::abs(number(999))) *
                               Vec3(number(3 * i), number(3 * i + 1), number(3 * i + 2)));

        const double displacement = largest_displacement(reference, now, packing.particles);
        if (!list_is_valid(reference, now, displacement)) {
            ++invalid;
            continue;
        }
        ++valid;
        // Images count from the stored centers, which were not wrapped again: they mean the same.
        for (const NearPair& pair : brute_force_neighbors(now, packing.particles.spheres))
            EXPECT_TRUE(std::binary_search(listed.begin(), listed.end(), pair)) << "seed " << seed;
    }
    EXPECT_GT(valid, 20);
    EXPECT_GT(invalid, 20);
}

}  // namespace
}  // namespace jam
