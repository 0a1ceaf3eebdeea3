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

/// Those that have been stirred: moved, or touched another, since the tiles were made. No other can
/// move. Lists are by blocks of ContactTiles::particles_per_block particles and in order; each
/// block's begins at the place of its first particle.
struct ActiveParticles {
    std::vector<char> stirred;         ///< by particle
    std::vector<Index> particles;      ///< the stirred ones
    std::vector<Index> end;            ///< size blocks
    std::vector<Index> newly_stirred;  ///< by the last call of stir
    std::vector<Index> awake;          ///< of the stirred ones those that are not idle
    std::vector<Index> awake_end;      ///< size blocks
    std::vector<char> grown;  ///< by block: whether some are stirred that are not listed yet

    Count block_count() const { return static_cast<Count>(end.size()); }
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

/// For new tiles: stirred are those in motion. None is awake before find_awake.
void begin_stirring(const Particles& particles, ActiveParticles& active);

/// Adds those that were found to touch another, in lists that may name them more than once.
void stir(std::span<const std::vector<Index>> woken, ActiveParticles& active);

/// Those of a block that are not idle, for loads and velocities as they are.
void find_awake(const Particles& particles, Count block, ActiveParticles& active);

/// Sum over blocks of body(block) -> Value, added in the order of the blocks.
/// Values of particles that are idle must be zero.
template <typename Value, typename Body>
Value sum_active(const ActiveParticles& active, const Value& zero, Body&& body) {
    return sum_blocks(active.block_count(), 1, zero,
                      [&](Count block, Count) { return body(block); });
}

}  // namespace jam
