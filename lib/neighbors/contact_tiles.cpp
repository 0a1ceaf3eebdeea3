// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/contact_tiles.h"

#include "cell/upper_map.h"
#include "core/check.h"
#include "core/lanes.h"

#include <algorithm>
#include <numeric>

namespace jam {

namespace {

constexpr Count rows_per_tile = 1024;
constexpr std::size_t most_participants = 1 << 16;
constexpr double rounding = 1e-12;

/// Makes the tiles of a range of rows with one thread's scratch.
class TileMaker {
  public:
    TileMaker(const NeighborList& candidates, const PeriodicCell& cell,
              const InteractionReach& reach, const Particles& particles,
              TileScratch::Thread& scratch)
        : candidates_(candidates),
          to_cartesian_(cell.matrix()),
          reach_(reach),
          close_reach_{.strain_margin = reach.strain_margin + rounding},
          particles_(particles),
          scratch_(scratch) {
        scratch_.participant_of.resize(particles.spheres.size(), none);
    }

    /// Appends the tiles of rows [begin, end): one, or more where one would have too many
    /// participants for 16-bit numbers.
    void make(Index begin, Index end, std::vector<ContactTile>& tiles) {
        find_near(begin, end);
        ContactTile tile;
        tile.first_row = begin;
        number_own(begin, end, tile);
        number_pairs(tile);
        if (scratch_.repeated_halo) sort_halo(tile);
        forget(tile);
        if (tile.participants.size() <= most_participants) {
            tiles.push_back(std::move(tile));
            return;
        }
        require(end - begin > 1,
                "neighbors: one particle is near {} others; let collections.ratio be smaller",
                tile.participants.size());
        const Index middle = begin + (end - begin) / 2;
        make(begin, middle, tiles);
        make(middle, end, tiles);
    }

  private:
    /// Without a branch: which of the candidates are near cannot be guessed.
    void find_near(Index begin, Index end) {
        auto& near = scratch_.near;
        auto& close = scratch_.close;
        near.resize(static_cast<std::size_t>(candidates_.pairs_of_rows(begin, end)) + 1);
        close.resize(near.size());
        std::size_t found = 0;
        for (Index i = begin; i < end; ++i) {
            const Double4 sphere = load4(particles_.spheres[static_cast<std::size_t>(i)]);
            for_each_four(candidates_.row(i), [&](const Neighbor* neighbors, int count) {
                const auto [are_near, are_close] = nearness(sphere, neighbors);
                const unsigned near_bits = bits_of(are_near) & bits_of_first(count);
                const unsigned close_bits = bits_of(are_close);
                for (unsigned k = 0; k < 4; ++k) {
                    near[found] = {i, neighbors[k]};
                    close[found] = static_cast<char>(close_bits >> k & 1u);
                    found += near_bits >> k & 1u;
                }
            });
        }
        near.resize(found);
        close.resize(found);
    }

    struct Nearness {
        Mask4 near, close;
    };

    Nearness nearness(const Double4& sphere, const Neighbor* neighbors) const {
        const auto separation = [&](const Neighbor& neighbor) {
            const auto j = static_cast<std::size_t>(neighbor.particle());
            const Double4 other = load4(particles_.spheres[j]);
            return with_fourth_of(sphere - other - load4(image_shifts[neighbor.image()]), other);
        };
        const Columns4 s = transposed({separation(neighbors[0]), separation(neighbors[1]),
                                       separation(neighbors[2]), separation(neighbors[3])});
        const Columns4 r = to_cartesian_(s);
        const Double4 squared = squared_length(r);
        const Double4 diameter = Double4{} + sphere[3];
        const Double4 farthest = reach_.of(diameter, s.w);
        const Double4 closest = close_reach_.of(diameter, s.w);
        return {squared <= farthest * farthest, squared <= closest * closest};
    }

    /// Own participants first and in the order of the rows, so that they are read in sequence.
    void number_own(Index begin, Index end, ContactTile& tile) {
        auto& own = scratch_.own;
        own.assign(static_cast<std::size_t>(end - begin), false);
        for (const auto& [i, neighbor] : scratch_.near) {
            own[static_cast<std::size_t>(i - begin)] = true;
            const Index j = neighbor.particle();
            if (neighbor.image() == home_image && j >= begin && j < end)
                own[static_cast<std::size_t>(j - begin)] = true;
        }
        scratch_.next_image.clear();
        for (Index i = begin; i < end; ++i)
            if (own[static_cast<std::size_t>(i - begin)]) number_of(Neighbor(i, home_image), tile);
        tile.own_count = static_cast<Index>(tile.participants.size());
    }

    /// The halo is numbered by first appearance.
    void number_pairs(ContactTile& tile) {
        scratch_.repeated_halo = false;
        tile.close = scratch_.close;
        tile.pairs.reserve(scratch_.near.size());
        for (const auto& [i, neighbor] : scratch_.near) {
            const std::uint32_t first = number_of(Neighbor(i, home_image), tile);
            const std::uint32_t second = number_of(neighbor, tile);
            tile.pairs.push_back(
                {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(second)});
        }
    }

    /// Number of a participant, added if it is new. Images of one particle are chained.
    std::uint32_t number_of(Neighbor participant, ContactTile& tile) {
        std::uint32_t* link =
            &scratch_.participant_of[static_cast<std::size_t>(participant.particle())];
        while (*link != none) {
            if (tile.participants[*link] == participant) return *link;
            if (static_cast<Index>(*link) >= tile.own_count) scratch_.repeated_halo = true;
            link = &scratch_.next_image[*link];
        }
        const auto number = static_cast<std::uint32_t>(tile.participants.size());
        *link = number;
        tile.participants.push_back(participant);
        scratch_.next_image.push_back(none);
        return number;
    }

    /// A particle that a tile sees through several images has several slots, added one after the
    /// other. Their order must not depend on which pairs happened to be near, or new tiles would
    /// change bits.
    void sort_halo(ContactTile& tile) {
        const auto own = static_cast<std::size_t>(tile.own_count);
        std::vector<std::pair<Neighbor, std::size_t>> halo;
        for (std::size_t p = own; p < tile.participants.size(); ++p)
            halo.emplace_back(tile.participants[p], p);
        std::sort(halo.begin(), halo.end(),
                  [](const auto& a, const auto& b) { return a.first.word() < b.first.word(); });
        std::vector<std::uint16_t> number(tile.participants.size());
        std::iota(number.begin(), number.begin() + tile.own_count, std::uint16_t{0});
        for (std::size_t k = 0; k < halo.size(); ++k) {
            tile.participants[own + k] = halo[k].first;
            number[halo[k].second] = static_cast<std::uint16_t>(own + k);
        }
        for (TilePair& pair : tile.pairs) pair.second = number[pair.second];
    }

    void forget(const ContactTile& tile) {
        for (const Neighbor participant : tile.participants)
            scratch_.participant_of[static_cast<std::size_t>(participant.particle())] = none;
    }

    static constexpr std::uint32_t none = ~0u;

    const NeighborList& candidates_;
    const UpperMap to_cartesian_;
    const InteractionReach& reach_;
    const InteractionReach close_reach_;
    const Particles& particles_;
    TileScratch::Thread& scratch_;
};

void collect_tiles(TileScratch& scratch, ContactTiles& tiles) {
    tiles.tiles.clear();
    tiles.slot_count = 0;
    for (auto& of_block : scratch.tiles_of_block) {
        for (ContactTile& tile : of_block) {
            tile.first_slot = tiles.slot_count;
            tiles.slot_count += tile.halo_count();
            tiles.tiles.push_back(std::move(tile));
        }
    }
}

/// Calls use(tile) for all tiles, many at once.
template <typename Use>
void for_each_tile(const ContactTiles& tiles, Use&& use) {
    for_each_block(static_cast<Count>(tiles.tiles.size()), 16, [&](Count, Count begin, Count end) {
        for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
            use(tiles.tiles[t]);
    });
}

/// Sorts the slots by block of the particle that each belongs to; stable, so that every particle's
/// loads keep the order of the tiles.
void index_halo_loads(Count particle_count, TileScratch& scratch, ContactTiles& tiles) {
    const auto slots = static_cast<std::size_t>(tiles.slot_count);
    for (auto* column :
         {&scratch.particle_of_slot, &scratch.block_of_slot, &scratch.slots_by_block})
        column->resize(slots);
    for_each_tile(tiles, [&](const ContactTile& tile) {
        auto slot = static_cast<std::size_t>(tile.first_slot);
        for (auto p = static_cast<std::size_t>(tile.own_count); p < tile.participants.size(); ++p) {
            const Index particle = tile.participants[p].particle();
            scratch.particle_of_slot[slot] = particle;
            scratch.block_of_slot[slot++] =
                static_cast<Index>(particle / ContactTiles::particles_per_block);
        }
    });
    const Count blocks = block_count(particle_count, ContactTiles::particles_per_block);
    counting_sort(scratch.block_of_slot, static_cast<Index>(blocks), tiles.halo_begin,
                  scratch.slots_by_block);
    tiles.halo_loads.resize(slots);
    for_each_block(tiles.slot_count, 1 << 14, [&](Count, Count begin, Count end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
            const Index slot = scratch.slots_by_block[k];
            tiles.halo_loads[k] = {scratch.particle_of_slot[static_cast<std::size_t>(slot)],
                                   static_cast<std::uint32_t>(slot)};
        }
    });
}

/// Who takes part only in the halo of others.
void find_those_only_in_halo(Count particle_count, std::vector<char>& takes_part,
                             ContactTiles& tiles) {
    takes_part.assign(static_cast<std::size_t>(particle_count), false);
    for_each_tile(tiles, [&](const ContactTile& tile) {
        for (std::size_t p = 0; p < static_cast<std::size_t>(tile.own_count); ++p)
            takes_part[static_cast<std::size_t>(tile.participants[p].particle())] = true;
    });
    const std::size_t blocks = tiles.halo_begin.size() - 1;
    tiles.only_in_halo.resize(blocks);
    for_each_block(static_cast<Count>(blocks), 1, [&](Count block, Count, Count) {
        const auto at = static_cast<std::size_t>(block);
        tiles.only_in_halo[at].clear();
        for (auto k = tiles.halo_begin[at]; k < tiles.halo_begin[at + 1]; ++k) {
            const Index particle = tiles.halo_loads[static_cast<std::size_t>(k)].particle;
            if (std::exchange(takes_part[static_cast<std::size_t>(particle)], true)) continue;
            tiles.only_in_halo[at].push_back(particle);
        }
    });
}

}  // namespace

Count ContactTiles::pair_count() const {
    Count count = 0;
    for (const ContactTile& tile : tiles) count += static_cast<Count>(tile.pairs.size());
    return count;
}

std::size_t ContactTiles::tile_of_row(Index row) const {
    const auto after = std::ranges::upper_bound(tiles, row, {}, &ContactTile::first_row);
    return static_cast<std::size_t>(after - tiles.begin()) - 1;
}

std::size_t ContactTiles::tile_of_slot(std::uint32_t slot) const {
    const auto after = std::ranges::upper_bound(tiles, Count{slot}, {}, &ContactTile::first_slot);
    return static_cast<std::size_t>(after - tiles.begin()) - 1;
}

void make_contact_tiles(const NeighborList& candidates, const PeriodicCell& cell,
                        const InteractionReach& reach, const Particles& particles,
                        TileScratch& scratch, ContactTiles& tiles) {
    const Count rows = candidates.particle_count();
    scratch.tiles_of_block.resize(static_cast<std::size_t>(block_count(rows, rows_per_tile)));
    for_each_block(rows, rows_per_tile, [&](Count block, Count begin, Count end) {
        auto& of_block = scratch.tiles_of_block[static_cast<std::size_t>(block)];
        of_block.clear();
        TileMaker(candidates, cell, reach, particles, scratch.threads.local())
            .make(static_cast<Index>(begin), static_cast<Index>(end), of_block);
    });
    collect_tiles(scratch, tiles);
    index_halo_loads(particles.size(), scratch, tiles);
    find_those_only_in_halo(particles.size(), scratch.takes_part, tiles);
}

}  // namespace jam
