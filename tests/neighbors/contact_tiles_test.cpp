// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/contact_tiles.h"

#include "neighbors/brute_force_neighbors.h"
#include "neighbors/find_neighbors.h"
#include "support/random_packings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace jam {
namespace {

struct Tiled {
    test::RandomPacking packing;
    ContactTiles tiles;
};

Tiled tile(int count, double size_ratio, const InteractionReach& inner) {
    Tiled tiled{
        test::random_packing(4, {.count = count, .size_ratio = size_ratio, .least_width = 1.3}),
        {}};
    Particles& particles = tiled.packing.particles;
    GridHierarchy hierarchy(geometric_collections(test::diameters_of(particles)));
    hierarchy.group(particles);
    NeighborScratch scratch;
    NeighborList candidates;
    find_candidates(hierarchy, tiled.packing.cell, {0.02, 0.1}, particles, scratch, candidates);
    TileScratch tile_scratch;
    // Twice: what one call leaves in the scratch must not show in the next.
    for (int repeat = 0; repeat < 2; ++repeat)
        make_contact_tiles(candidates, tiled.packing.cell, inner, particles, tile_scratch,
                           tiled.tiles);
    return tiled;
}

TEST(ContactTiles, HoldEveryNearPairOnce) {
    for (const double size_ratio : {1.0, 5.0, 50.0}) {
        const InteractionReach inner{0.01, 0.03};
        const Tiled tiled = tile(4000, size_ratio, inner);
        std::vector<NearPair> pairs;
        for (const ContactTile& tile : tiled.tiles.tiles)
            for (const TilePair pair : tile.pairs) {
                const Neighbor first = tile.participants[pair.first];
                const Neighbor second = tile.participants[pair.second];
                ASSERT_LT(pair.first, tile.own_count);
                pairs.push_back(
                    canonical_pair(first.particle(), second.particle(), image_of(second.image())));
            }
        std::sort(pairs.begin(), pairs.end());
        EXPECT_EQ(pairs, brute_force_neighbors(tiled.packing.cell, tiled.packing.particles.spheres,
                                               inner.strain_margin, inner.skin));
        EXPECT_EQ(tiled.tiles.pair_count(), static_cast<Count>(pairs.size()));
        EXPECT_GT(tiled.tiles.tiles.size(), 2u);
    }
}

TEST(ContactTiles, EverySlotHasOneOwnerAndEveryParticleOneTile) {
    const Tiled tiled = tile(6000, 5.0, {0.0, 0.02});
    const ContactTiles& tiles = tiled.tiles;
    std::vector<Index> owner(static_cast<std::size_t>(tiles.slot_count), -1);
    std::set<Index> own;
    for (const ContactTile& tile : tiles.tiles)
        for (std::size_t p = 0; p < tile.participants.size(); ++p) {
            const Index particle = tile.participants[p].particle();
            if (static_cast<Index>(p) < tile.own_count) {
                EXPECT_TRUE(own.insert(particle).second);
            } else {
                owner[static_cast<std::size_t>(tile.first_slot) + p -
                      static_cast<std::size_t>(tile.own_count)] = particle;
            }
        }
    std::set<Index> bare;
    for (const auto& block : tiles.only_in_halo) bare.insert(block.begin(), block.end());
    std::set<std::uint32_t> slots;
    for (const HaloLoad& load : tiles.halo_loads) {
        EXPECT_TRUE(slots.insert(load.slot).second);
        EXPECT_EQ(owner[load.slot], load.particle);
        // Each particle's load starts from its own tile or from zero, never from the step before.
        EXPECT_NE(own.count(load.particle), bare.count(load.particle));
    }
    EXPECT_EQ(static_cast<Count>(slots.size()), tiles.slot_count);
    EXPECT_GT(bare.size(), 0u);
}

TEST(ContactTiles, EveryParticleFindsItsTiles) {
    const Tiled tiled = tile(20000, 5.0, {0.0, 0.02});
    const ContactTiles& tiles = tiled.tiles;
    std::size_t looked_at = 0;
    for (Index i = 0; i < 20000; ++i)
        tiles.for_each_tile_of(i, [&](std::size_t t) {
            ASSERT_LT(t, tiles.tiles.size());
            ++looked_at;
        });
    for (std::size_t t = 0; t < tiles.tiles.size(); ++t)
        for (const Neighbor participant : tiles.tiles[t].participants) {
            std::set<std::size_t> found;
            tiles.for_each_tile_of(participant.particle(),
                                   [&](std::size_t at) { found.insert(at); });
            ASSERT_TRUE(found.count(t)) << participant.particle();
        }
    EXPECT_LT(looked_at, 20000 * tiles.tiles.size() / 2) << "as many as all, which tells nothing";
}

}  // namespace
}  // namespace jam
