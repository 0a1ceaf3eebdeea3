// SPDX-License-Identifier: BSD-3-Clause
// The particles that a relaxation has to look at. Near rest most particles of a wide distribution
// are rattlers that touch nothing and stand still: they cost nothing until something nears them.
#pragma once

#include "core/lanes.h"
#include "core/parallel.h"
#include "neighbors/contact_tiles.h"
#include "particles/particles.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace jam {

/// Those that take part in a tile or are in motion, by blocks of ContactTiles::particles_per_block
/// particles and in order within a block. While the tiles stand no other can move.
struct ActiveParticles {
    std::vector<Index> particles;
    std::vector<Index> block_begin;  ///< size blocks + 1
    std::vector<Index> awake;        ///< of each block those that are not idle, from its begin on
    std::vector<Index> awake_end;    ///< size blocks

    Count block_count() const { return static_cast<Count>(block_begin.size()) - 1; }
    Count awake_count() const;
    std::span<const Index> of_block(Count block) const;
    std::span<const Index> awake_of_block(Count block) const;
};

/// Four particles that are looked at together. The last ones of a block may be fewer: then one of
/// them stands in the other places, too.
struct Quad {
    std::array<std::size_t, 4> at;
    int count;
};

/// Calls body(quad) for all of them, in order, and expect(i) for each particle some time before.
template <typename Expect, typename Body>
void for_each_quad(std::span<const Index> particles, Expect&& expect, Body&& body) {
    std::size_t coming = records_ahead;
    for_each_four(particles, [&](const Index* four, int count) {
        const auto at = [four](int k) { return static_cast<std::size_t>(four[k]); };
        for (const std::size_t end = std::min(coming + 4, particles.size()); coming < end; ++coming)
            expect(static_cast<std::size_t>(particles[coming]));
        body(Quad{{at(0), at(1), at(2), at(3)}, count});
    });
}

template <typename Record>
Columns4 load_columns(const std::vector<Record>& records, const Quad& quad) {
    return transposed({load4(records[quad.at[0]]), load4(records[quad.at[1]]),
                       load4(records[quad.at[2]]), load4(records[quad.at[3]])});
}

template <typename Record>
void store_columns(const Columns4& columns, const Quad& quad, std::vector<Record>& records) {
    const Columns4 rows = transposed(columns);
    store4(rows.x, records[quad.at[0]]);
    store4(rows.y, records[quad.at[1]]);
    store4(rows.z, records[quad.at[2]]);
    store4(rows.w, records[quad.at[3]]);
}

// All without a branch: who rests cannot be guessed.
inline bool stands_still(const Particles& particles, std::size_t i) {
    constexpr unsigned velocity = 0b111;
    return (bits_of(load4(particles.motions[i]) != Double4{}) & velocity) == 0;
}

/// Whether a particle had contacts when the forces were last evaluated.
inline bool touches_another(const Particles& particles, std::size_t i) {
    return particles.loads[i].contacts != 0.0;
}

/// Whether a particle stands still and touches nothing.
inline bool is_idle(const Particles& particles, std::size_t i) {
    return !(touches_another(particles, i) | !stands_still(particles, i));
}

/// For new tiles, and velocities as they are. None is awake before find_awake.
void find_active_particles(const ContactTiles& tiles, const Particles& particles,
                           ActiveParticles& active);

/// Those of a block's active particles that are not idle, for loads and velocities as they are.
void find_awake(const Particles& particles, Count block, ActiveParticles& active);

/// Sum over blocks of body(block) -> Value, added in the order of the blocks.
/// Values of particles that are idle must be zero.
template <typename Value, typename Body>
Value sum_active(const ActiveParticles& active, const Value& zero, Body&& body) {
    return sum_blocks(active.block_count(), 1, zero,
                      [&](Count block, Count) { return body(block); });
}

}  // namespace jam
