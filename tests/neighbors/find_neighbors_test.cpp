// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/find_neighbors.h"

#include "core/check.h"
#include "core/random.h"
#include "core/state_hash.h"
#include "neighbors/brute_force_neighbors.h"
#include "support/random_packings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace jam {
namespace {

using test::random_packing;
using test::RandomPacking;
using test::RandomPackingSettings;

struct Searched {
    NeighborList candidates;
    NeighborList near;
};

Searched search(RandomPacking& packing, const SizeCollections& collections,
                const InteractionReach& reach, NeighborMethod method = NeighborMethod::multi) {
    GridHierarchy hierarchy(collections_for(method, collections));
    hierarchy.group(packing.particles);
    NeighborScratch scratch;
    Searched searched;
    find_candidates(hierarchy, packing.cell, reach, packing.particles, scratch, searched.candidates,
                    method);
    searched.near = within_reach(searched.candidates, packing.cell, reach, packing.particles);
    return searched;
}

void expect_brute_force_list(RandomPacking packing, const SizeCollections& collections,
                             const InteractionReach& reach, NeighborMethod method) {
    const Searched searched = search(packing, collections, reach, method);
    const auto expected = brute_force_neighbors(packing.cell, packing.particles.spheres,
                                                reach.strain_margin, reach.skin);
    EXPECT_EQ(canonical_pairs(searched.near), expected);
    // The search itself may list a little more, by no more than its rounding: one per mille.
    const Count near = searched.near.pair_count();
    EXPECT_LE(searched.candidates.pair_count(), near + near / 100 + 3);
}

void expect_brute_force_list(const RandomPacking& packing, const SizeCollections& collections,
                             const InteractionReach& reach) {
    for (const NamedNeighborMethod& one : neighbor_methods) {
        SCOPED_TRACE(one.name);
        expect_brute_force_list(packing, collections, reach, one.method);
    }
}

TEST(FindNeighbors, EqualsBruteForceInTiltedCellsOfAnySizeRatio) {
    std::size_t pairs = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        RandomPackingSettings settings;
        settings.count = 150;
        settings.size_ratio = std::pow(100.0, uniform(seed, RandomStream::tests, 1u << 20));
        const RandomPacking packing = random_packing(seed, settings);
        const double room =
            packing.cell.perpendicular_widths().minCoeff() / settings.size_ratio - 1.0;
        const InteractionReach reach{0.5 * std::min(0.05, room), 0.01};
        SCOPED_TRACE(fmt::format("seed {}, size ratio {}", seed, settings.size_ratio));
        expect_brute_force_list(
            packing, geometric_collections(test::diameters_of(packing.particles)), reach);
        pairs += brute_force_neighbors(packing.cell, packing.particles.spheres).size();
    }
    EXPECT_GT(pairs, 10000u);
}

TEST(FindNeighbors, EqualsBruteForceInCellsBarelyWiderThanTheLargestSphere) {
    for (std::uint64_t seed = 100; seed < 120; ++seed) {
        const RandomPacking packing = random_packing(
            seed,
            {.count = 12, .size_ratio = 1.0 + 0.2 * double(seed - 100), .volume_fraction = 1.2});
        SCOPED_TRACE(fmt::format("seed {}", seed));
        expect_brute_force_list(
            packing, geometric_collections(test::diameters_of(packing.particles)), {0.0, 0.0});
    }
}

TEST(FindNeighbors, ASphereMeetsItsOwnImages) {
    RandomPacking packing = random_packing(1, {.count = 1, .size_ratio = 2.0});
    packing.cell = PeriodicCell::cubic(2.05);
    const Searched searched =
        search(packing, geometric_collections(test::diameters_of(packing.particles)), {0.0, 0.025});
    // Three pairs of opposite faces, each once.
    EXPECT_EQ(searched.near.pair_count(), 3);
}

TEST(FindNeighbors, EqualsBruteForceForAnyCollections) {
    const RandomPacking packing = random_packing(7, {.count = 400, .size_ratio = 20.0});
    const std::vector<double> diameters = test::diameters_of(packing.particles);
    for (const double ratio : {1.3, 2.0, 4.0, 100.0})
        expect_brute_force_list(packing, geometric_collections(diameters, {.ratio = ratio}),
                                {0.01, 0.05});
    for (const int intervals : {1, 3, 10})
        expect_brute_force_list(packing, linear_collections(diameters, intervals), {0.01, 0.05});
}

TEST(FindNeighbors, AWideSkinIsRight) {
    const RandomPacking packing =
        random_packing(8, {.count = 300, .size_ratio = 1.5, .volume_fraction = 0.1});
    expect_brute_force_list(packing, geometric_collections(test::diameters_of(packing.particles)),
                            {0.1, 1.0});
}

std::uint64_t hash_of_search(int threads, int count, NeighborMethod method) {
    return run_with_threads(threads, [&] {
        RandomPacking packing = random_packing(9, {.count = count, .size_ratio = 30.0});
        const Searched searched =
            search(packing, geometric_collections(test::diameters_of(packing.particles)),
                   {0.01, 0.05}, method);
        std::uint64_t hash = state_hash<Neighbor>(searched.candidates.neighbors);
        hash = state_hash<Count>(searched.candidates.row_begin, hash);
        return state_hash<std::uint32_t>(packing.particles.ids, hash);
    });
}

TEST(FindNeighbors, SameRowsForAnyThreadCount) {
    const auto rows_with = [](int threads) {
        return hash_of_search(threads, 20000, NeighborMethod::multi);
    };
    const std::uint64_t alone = rows_with(1);
    for (const int threads : {2, 3, 5, 8, 16}) EXPECT_EQ(rows_with(threads), alone) << threads;
}

TEST(FindNeighbors, TheOlderMethodsGiveTheSameRowsForAnyThreadCount) {
    for (const auto method : {NeighborMethod::multi_old, NeighborMethod::one_grid}) {
        const std::uint64_t alone = hash_of_search(1, 3000, method);
        EXPECT_EQ(hash_of_search(3, 3000, method), alone);
        EXPECT_EQ(hash_of_search(8, 3000, method), alone);
    }
}

TEST(FindNeighbors, MemoryFollowsTheParticlesAtAnyRatio) {
    RandomPacking packing = random_packing(10, {.count = 50, .size_ratio = 1000.0});
    GridHierarchy hierarchy(geometric_collections(test::diameters_of(packing.particles)));
    hierarchy.group(packing.particles);
    NeighborScratch scratch;
    NeighborList list;
    find_candidates(hierarchy, packing.cell, {0.01, 0.1}, packing.particles, scratch, list);
    for (const CollectionGrid& grid : hierarchy.grids())
        EXPECT_LE(grid.bin_count(), 2 * grid.member_count());
    find_candidates(hierarchy, packing.cell, {0.01, 0.1}, packing.particles, scratch, list,
                    NeighborMethod::multi_old);
    EXPECT_LE(scratch.fine_grid.grid.bin_count(), 2 * packing.particles.size());
}

TEST(FindNeighbors, RefusesACellNarrowerThanTheReach) {
    RandomPacking packing =
        random_packing(11, {.count = 5, .size_ratio = 3.0, .least_width = 1.01});
    packing.cell = PeriodicCell::cubic(3.0);
    EXPECT_THROW(
        search(packing, geometric_collections(test::diameters_of(packing.particles)), {0.0, 0.1}),
        InputError);
}

}  // namespace
}  // namespace jam
