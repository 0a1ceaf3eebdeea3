// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/verlet_lists.h"

#include "core/random.h"
#include "neighbors/brute_force_neighbors.h"
#include "support/random_packings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace jam {
namespace {

double number(std::uint64_t id, std::uint32_t component) {
    return 2.0 * uniform(5, RandomStream::tests, id, component) - 1.0;
}

/// Moves every particle by up to `largest`, many of them on and on in one direction, and strains
/// the cell.
StepMotion move(std::uint64_t step, double largest, test::RandomPacking& packing) {
    StepMotion moved;
    Mat3 strain = Mat3::Zero();
    strain(0, 0) = 1e-4 * number(step, 1);
    strain(0, 2) = 1e-4 * number(step, 2);
    strain(1, 1) = -5e-5;
    moved.strain = strain.norm();
    const PeriodicCell before = packing.cell;
    packing.cell = PeriodicCell(Mat3((Mat3::Identity() + strain) * before.matrix()));
    const PeriodicCell halfway(Mat3((Mat3::Identity() + 0.5 * strain) * before.matrix()));
    Particles& particles = packing.particles;
    for (std::size_t i = 0; i < particles.spheres.size(); ++i) {
        const std::uint64_t id = particles.ids[i];
        const std::uint64_t direction = id % 2 == 0 ? id : 1000 * (step + 1) + id;
        const Vec3 path = largest *
                          Vec3(number(direction, 3), number(direction, 4), number(direction, 5)) /
                          std::sqrt(3.0);
        particles.spheres[i].center += halfway.fractional(path);
        moved.displacement = std::max(moved.displacement, path.norm());
    }
    return moved;
}

std::set<NearPair> pairs_in(const ContactTiles& tiles) {
    std::set<NearPair> pairs;
    for (const ContactTile& tile : tiles.tiles) {
        for (const TilePair pair : tile.pairs) {
            const Neighbor first = tile.participants[pair.first];
            const Neighbor second = tile.participants[pair.second];
            pairs.insert(
                canonical_pair(first.particle(), second.particle(), image_of(second.image())));
        }
    }
    return pairs;
}

TEST(VerletLists, HoldEveryContactWhileTheyStand) {
    test::RandomPacking packing =
        test::random_packing(8, {.count = 300, .size_ratio = 5.0, .least_width = 1.3});
    Particles& particles = packing.particles;
    particles.loads.resize(particles.spheres.size());
    VerletLists lists(test::diameters_of(particles), ListSettings{});
    lists.hierarchy.group(particles);
    const double largest = 2e-4 * lists.smallest_diameter;
    StepMotion expected{.displacement = largest, .strain = 1e-4};
    renew_lists(lists, packing.cell, {}, expected, particles);
    int stood = 0;
    int filtered = 0;
    int searched = 0;
    for (std::uint64_t step = 0; step < 1500; ++step) {
        const StepMotion moved = move(step, largest, packing);
        switch (keep_tiles_valid(lists, packing.cell, moved, expected, particles)) {
            case ListRenewal::none:
                ++stood;
                break;
            case ListRenewal::tiles:
                ++filtered;
                break;
            case ListRenewal::search_needed:
                renew_lists(lists, packing.cell, moved, expected, particles);
                ++searched;
        }
        EXPECT_GE(lists.outer_displacement,
                  largest_displacement(lists.outer, packing.cell, particles));
        EXPECT_GE(lists.inner_displacement,
                  largest_displacement(lists.inner, packing.cell, particles));
        if (step % 10 != 9) continue;
        const std::set<NearPair> listed = pairs_in(lists.tiles);
        for (const NearPair& pair : brute_force_neighbors(packing.cell, particles.spheres))
            ASSERT_TRUE(listed.contains(pair)) << "step " << step;
    }
    EXPECT_GT(stood, 1000);
    EXPECT_GT(filtered, 10);
    EXPECT_GT(searched, 1);
}

TEST(VerletLists, FastMotionIsGivenAWiderSkin) {
    test::RandomPacking packing =
        test::random_packing(9, {.count = 300, .size_ratio = 3.0, .least_width = 2.0});
    Particles& particles = packing.particles;
    particles.loads.resize(particles.spheres.size());
    const ListSettings settings;
    VerletLists lists(test::diameters_of(particles), settings);
    lists.hierarchy.group(particles);
    const double smallest = lists.smallest_diameter;
    const auto skin_after = [&](double displacement) {
        renew_lists(lists, packing.cell, {.displacement = displacement * smallest}, {}, particles);
        return lists.outer.reach.skin / smallest;
    };
    EXPECT_DOUBLE_EQ(skin_after(0.0), settings.outer_skin);
    EXPECT_DOUBLE_EQ(skin_after(5e-3), 5e-3 * settings.outer_steps);
    EXPECT_DOUBLE_EQ(skin_after(1.0), settings.widest_outer_skin);
}

}  // namespace
}  // namespace jam
