// SPDX-License-Identifier: BSD-3-Clause
// The particles that a relaxation has to look at. Near rest most particles of a wide distribution
// are rattlers that touch nothing and stand still: they cost nothing until something nears them.
#pragma once

#include "core/parallel.h"
#include "neighbors/contact_tiles.h"
#include "particles/particles.h"

#include <span>
#include <vector>

namespace jam {

/// Those that take part in a tile or are in motion, by blocks of ContactTiles::particles_per_block
/// particles and in order within a block. While the tiles stand no other can move.
struct ActiveParticles {
    std::vector<Index> particles;
    std::vector<Index> block_begin;  ///< size blocks + 1

    Count block_count() const { return static_cast<Count>(block_begin.size()) - 1; }
    std::span<const Index> of_block(Count block) const;
};

/// Whether a particle stands still and touches nothing.
bool is_idle(const Particles& particles, std::size_t i);

/// For new tiles, and velocities as they are.
void find_active_particles(const ContactTiles& tiles, const Particles& particles,
                           ActiveParticles& active);

/// Sum over blocks of body(block) -> Value, added in the order of the blocks.
/// Values of particles that are not active must be zero.
template <typename Value, typename Body>
Value sum_active(const ActiveParticles& active, const Value& zero, Body&& body) {
    return sum_blocks(active.block_count(), 1, zero,
                      [&](Count block, Count) { return body(block); });
}

}  // namespace jam
