// SPDX-License-Identifier: BSD-3-Clause
// What of a tile has to be looked at while most particles rest. Rattlers of a wide distribution lie
// side by side, and most near pairs are between two that have not moved since the tiles were made:
// no such pair comes to touch unless straining the cell alone can bring it together.
#pragma once

#include "neighbors/contact_tiles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace jam {

/// The pairs of a tile of whom one has been stirred, moved or touched, since the tiles were made,
/// or that are close, in their order in the tile; so sums over them keep their order, too.
struct LiveTile {
    bool stale = true;                   ///< not made yet, or one more has been stirred since
    bool whole = false;                  ///< all pairs of the tile are live
    std::vector<Neighbor> participants;  ///< of the live pairs, in the order of the tile
    std::vector<char> is_stirred;        ///< by participant
    Index own_count = 0;
    std::vector<TilePair> pairs;
    std::vector<std::uint32_t> slots;  ///< of the participants in the halo
};

/// Memory of the renewal, kept between calls.
struct LiveTileScratch {
    std::vector<char> stirred;          ///< by participant of the tile
    std::vector<std::uint16_t> number;  ///< by participant of the tile: among the live ones
};

/// Makes it anew. `stirred` is by particle; while the tile stands, whoever is in it stays in it.
void renew_live_tile(const ContactTile& tile, std::span<const char> stirred,
                     LiveTileScratch& scratch, LiveTile& live);

}  // namespace jam
