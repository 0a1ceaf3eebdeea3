// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/active_particles.h"

namespace jam {

namespace {

bool stands_still(const Particles& particles, std::size_t i) {
    return particles.motions[i].velocity.isZero(0.0);
}

bool may_move(const ContactTiles& tiles, const Particles& particles, std::size_t i) {
    return tiles.takes_part[i] || !stands_still(particles, i);
}

}  // namespace

std::span<const Index> ActiveParticles::of_block(Count block) const {
    const auto at = static_cast<std::size_t>(block);
    return std::span(particles).subspan(block_begin[at], block_begin[at + 1] - block_begin[at]);
}

bool is_idle(const Particles& particles, std::size_t i) {
    return particles.loads[i].contacts == 0.0 && stands_still(particles, i);
}

void find_active_particles(const ContactTiles& tiles, const Particles& particles,
                           ActiveParticles& active) {
    constexpr Count block_size = ContactTiles::particles_per_block;
    const Count count = particles.size();
    active.block_begin.assign(static_cast<std::size_t>(block_count(count, block_size)) + 1, 0);
    for_each_block(count, block_size, [&](Count block, Count begin, Count end) {
        Index& found = active.block_begin[static_cast<std::size_t>(block)];
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            found += may_move(tiles, particles, i) ? 1 : 0;
    });
    active.particles.resize(static_cast<std::size_t>(exclusive_scan(active.block_begin)));
    for_each_block(count, block_size, [&](Count block, Count begin, Count end) {
        auto place = static_cast<std::size_t>(active.block_begin[static_cast<std::size_t>(block)]);
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            if (may_move(tiles, particles, i)) active.particles[place++] = static_cast<Index>(i);
    });
}

}  // namespace jam
