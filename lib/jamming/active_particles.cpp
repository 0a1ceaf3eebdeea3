// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/active_particles.h"

namespace jam {

namespace {

bool may_move(const ContactTiles& tiles, const Particles& particles, std::size_t i) {
    return tiles.takes_part[i] || !stands_still(particles, i);
}

}  // namespace

Count ActiveParticles::awake_count() const {
    Count count = 0;
    for (Count block = 0; block < block_count(); ++block)
        count += static_cast<Count>(awake_of_block(block).size());
    return count;
}

std::span<const Index> ActiveParticles::of_block(Count block) const {
    const auto at = static_cast<std::size_t>(block);
    return std::span(particles).subspan(block_begin[at], block_begin[at + 1] - block_begin[at]);
}

std::span<const Index> ActiveParticles::awake_of_block(Count block) const {
    const auto at = static_cast<std::size_t>(block);
    return std::span(awake).subspan(block_begin[at], awake_end[at] - block_begin[at]);
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
    active.awake.resize(active.particles.size());
    active.awake_end.assign(active.block_begin.begin(), active.block_begin.end() - 1);
}

void find_awake(const Particles& particles, Count block, ActiveParticles& active) {
    const auto at = static_cast<std::size_t>(block);
    auto place = static_cast<std::size_t>(active.block_begin[at]);
    const std::span<const Index> of_block = active.of_block(block);
    const auto expect = [&](std::size_t k) {
        const auto i = static_cast<std::size_t>(of_block[k]);
        expect_read(particles.loads[i]);
        expect_read(particles.motions[i]);
    };
    for_each_expected(0, of_block.size(), expect, [&](std::size_t k) {
        const Index i = of_block[k];
        active.awake[place] = i;
        place += is_idle(particles, static_cast<std::size_t>(i)) ? 0 : 1;
    });
    active.awake_end[at] = static_cast<Index>(place);
}

}  // namespace jam
