// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/active_particles.h"

#include <utility>

namespace jam {

namespace {

constexpr Count block_size = ContactTiles::particles_per_block;

std::span<const Index> listed(const std::vector<Index>& list, Count block,
                              const std::vector<Index>& end) {
    const auto begin = static_cast<std::size_t>(block * block_size);
    const auto block_end = static_cast<std::size_t>(end[static_cast<std::size_t>(block)]);
    return std::span(list).subspan(begin, block_end - begin);
}

void list_stirred(Count block, ActiveParticles& active) {
    const auto at = static_cast<std::size_t>(block);
    const auto begin = static_cast<std::size_t>(block * block_size);
    const std::size_t end = std::min(begin + block_size, active.stirred.size());
    std::size_t place = begin;
    for (std::size_t i = begin; i < end; ++i) {
        active.particles[place] = static_cast<Index>(i);
        place += active.stirred[i] ? 1 : 0;
    }
    active.end[at] = static_cast<Index>(place);
    active.grown[at] = false;
}

}  // namespace

Count ActiveParticles::awake_count() const {
    Count sum = 0;
    for (Count block = 0; block < block_count(); ++block)
        sum += static_cast<Count>(awake_of_block(block).size());
    return sum;
}

std::span<const Index> ActiveParticles::of_block(Count block) const {
    return listed(particles, block, end);
}

std::span<const Index> ActiveParticles::awake_of_block(Count block) const {
    return listed(awake, block, awake_end);
}

void begin_stirring(const Particles& particles, ActiveParticles& active) {
    const Count count = particles.size();
    const auto blocks = static_cast<std::size_t>(block_count(count, block_size));
    active.stirred.resize(static_cast<std::size_t>(count));
    active.particles.resize(static_cast<std::size_t>(count));
    active.awake.resize(static_cast<std::size_t>(count));
    active.end.resize(blocks);
    active.grown.resize(blocks);
    active.awake_end.resize(blocks);
    for_each_block(count, block_size, [&](Count block, Count begin, Count end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            active.stirred[i] = !stands_still(particles, i);
        list_stirred(block, active);
        active.awake_end[static_cast<std::size_t>(block)] = static_cast<Index>(begin);
    });
}

void stir(std::span<const std::vector<Index>> woken, ActiveParticles& active) {
    active.newly_stirred.clear();
    for (const std::vector<Index>& some : woken) {
        for (const Index i : some) {
            if (std::exchange(active.stirred[static_cast<std::size_t>(i)], true)) continue;
            active.grown[static_cast<std::size_t>(i / block_size)] = true;
            active.newly_stirred.push_back(i);
        }
    }
}

void find_awake(const Particles& particles, Count block, ActiveParticles& active) {
    const auto at = static_cast<std::size_t>(block);
    if (active.grown[at]) list_stirred(block, active);
    auto place = static_cast<std::size_t>(block * block_size);
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
