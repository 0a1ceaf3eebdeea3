// SPDX-License-Identifier: BSD-3-Clause
// The near pairs cut into tiles: what one task needs to sum forces without asking anybody.
//
// A tile is a run of rows of the candidate list. Its participants are the particles of those rows
// that are near something (its own), and whatever lies near them outside the rows, each with the
// image through which it is seen (its halo). A pair names two participants by 16-bit numbers, so
// that a task copies the participants once, in Cartesian coordinates with their images resolved,
// and then works in the cache. Loads on its own particles are its to write; loads on the halo go to
// slots, one for each halo participant, added to the particles afterwards in the order of the
// tiles. No two tasks write to the same place, no sum depends on who ran when: the same bits for
// any number of threads.
#pragma once

#include "cell/periodic_cell.h"
#include "core/parallel.h"
#include "grids/interaction_reach.h"
#include "neighbors/neighbor_list.h"
#include "particles/particles.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace jam {

/// Two participants of a tile; the first is always one of its own.
struct TilePair {
    std::uint16_t first;
    std::uint16_t second;
};

struct ContactTile {
    Index first_row = 0;                 ///< of the candidate list
    std::vector<Neighbor> participants;  ///< own ones first, with the home image
    Index own_count = 0;
    std::vector<TilePair> pairs;
    /// By pair: whether the tiles' strain margin alone may bring it together.
    std::vector<char> close;
    Count first_slot = 0;  ///< of the halo: participant own_count + k has slot first_slot + k

    Index halo_count() const { return static_cast<Index>(participants.size()) - own_count; }
};

/// A slot whose load belongs to a particle.
struct HaloLoad {
    Index particle;
    std::uint32_t slot;
};

struct ContactTiles {
    static constexpr Count particles_per_block = 2048;

    std::vector<ContactTile> tiles;
    Count slot_count = 0;
    /// By blocks of particles; within a block in the order of the tiles.
    std::vector<HaloLoad> halo_loads;
    std::vector<Index> halo_begin;  ///< size blocks + 1
    /// By block: particles that are in the halo of other tiles and take part in none of their own.
    /// No tile writes their loads, so these start from zero.
    std::vector<std::vector<Index>> only_in_halo;

    Count pair_count() const;
    /// Calls use(t) for every tile t in which a particle may take part.
    template <typename Use>
    void for_each_tile_of(Index particle, Use&& use) const;

  private:
    std::size_t tile_of_row(Index row) const;
    std::size_t tile_of_slot(std::uint32_t slot) const;
};

template <typename Use>
void ContactTiles::for_each_tile_of(Index particle, Use&& use) const {
    use(tile_of_row(particle));
    const auto block = static_cast<std::size_t>(particle / particles_per_block);
    for (Index k = halo_begin[block]; k < halo_begin[block + 1]; ++k) {
        const HaloLoad& halo = halo_loads[static_cast<std::size_t>(k)];
        if (halo.particle == particle) use(tile_of_slot(halo.slot));
    }
}

/// Memory of the refilter, kept between calls.
struct TileScratch {
    struct Thread {
        std::vector<std::uint32_t> participant_of;  ///< by particle: its first number in the tile
        std::vector<std::uint32_t> next_image;  ///< by participant: another image of the same one
        std::vector<std::pair<Index, Neighbor>> near;
        std::vector<char> close;     ///< by near pair
        std::vector<char> own;       ///< by row: whether it takes part
        bool repeated_halo = false;  ///< some particle is in the halo through several images
    };
    PerThread<Thread> threads;
    std::vector<std::vector<ContactTile>> tiles_of_block;
    std::vector<Index> particle_of_slot, block_of_slot, slots_by_block;
    std::vector<char> takes_part;  ///< by particle: whether it is in any tile
};

/// Keeps the candidates within `reach` at the particles' present places, tested in double
/// precision, and cuts them into tiles. Throws InputError if one particle has more than 65535 near
/// ones in its row.
void make_contact_tiles(const NeighborList& candidates, const PeriodicCell& cell,
                        const InteractionReach& reach, const Particles& particles,
                        TileScratch& scratch, ContactTiles& tiles);

}  // namespace jam
