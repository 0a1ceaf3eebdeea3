// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/live_tile.h"

#include <numeric>

namespace jam {

namespace {

/// A tile is live as a whole where more than one in so many of its participants is stirred: soon
/// most are.
constexpr Count one_stirred_in = 2;

/// Returns how many of the tile's participants are stirred.
Count find_stirred(const ContactTile& tile, std::span<const char> stirred,
                   std::vector<char>& of_participant) {
    of_participant.resize(tile.participants.size());
    Count count = 0;
    for (std::size_t p = 0; p < tile.participants.size(); ++p) {
        const char is_stirred = stirred[static_cast<std::size_t>(tile.participants[p].particle())];
        of_participant[p] = is_stirred;
        count += is_stirred;
    }
    return count;
}

/// Without a branch: which pairs are live cannot be guessed. Numbers are 1 for who is in one.
void find_live_pairs(const ContactTile& tile, LiveTileScratch& scratch, LiveTile& live) {
    scratch.number.assign(tile.participants.size(), 0);
    live.pairs.resize(tile.pairs.size());
    std::size_t found = 0;
    for (std::size_t k = 0; k < tile.pairs.size(); ++k) {
        const auto [first, second] = tile.pairs[k];
        const int is_live = tile.close[k] | scratch.stirred[first] | scratch.stirred[second];
        live.pairs[found] = tile.pairs[k];
        found += static_cast<std::size_t>(is_live);
        scratch.number[first] = static_cast<std::uint16_t>(scratch.number[first] | is_live);
        scratch.number[second] = static_cast<std::uint16_t>(scratch.number[second] | is_live);
    }
    live.pairs.resize(found);
}

void number_participants(const ContactTile& tile, LiveTileScratch& scratch, LiveTile& live) {
    live.participants.clear();
    live.is_stirred.clear();
    live.slots.clear();
    live.own_count = 0;
    const auto own_count = static_cast<std::size_t>(tile.own_count);
    for (std::size_t p = 0; p < tile.participants.size(); ++p) {
        if (scratch.number[p] == 0) continue;
        scratch.number[p] = static_cast<std::uint16_t>(live.participants.size());
        live.participants.push_back(tile.participants[p]);
        live.is_stirred.push_back(scratch.stirred[p]);
        if (p < own_count)
            ++live.own_count;
        else
            live.slots.push_back(static_cast<std::uint32_t>(
                static_cast<std::size_t>(tile.first_slot) + p - own_count));
    }
}

void take_whole(const ContactTile& tile, LiveTile& live) {
    live.whole = true;
    live.participants = tile.participants;
    live.own_count = tile.own_count;
    live.pairs = tile.pairs;
    live.slots.resize(static_cast<std::size_t>(tile.halo_count()));
    std::iota(live.slots.begin(), live.slots.end(), static_cast<std::uint32_t>(tile.first_slot));
}

}  // namespace

void renew_live_tile(const ContactTile& tile, std::span<const char> stirred,
                     LiveTileScratch& scratch, LiveTile& live) {
    live.stale = false;
    const Count count = find_stirred(tile, stirred, scratch.stirred);
    if (one_stirred_in * count > static_cast<Count>(tile.participants.size())) {
        if (!live.whole) take_whole(tile, live);
        live.is_stirred = scratch.stirred;
        return;
    }
    find_live_pairs(tile, scratch, live);
    number_participants(tile, scratch, live);
    for (TilePair& pair : live.pairs)
        pair = {scratch.number[pair.first], scratch.number[pair.second]};
}

}  // namespace jam
