// SPDX-License-Identifier: BSD-3-Clause
#include "support/state_bits.h"

#include "core/state_hash.h"

namespace jam::test {

std::uint64_t bits_of(const JamState& state) {
    std::uint64_t hash = state_hash<Sphere>(state.particles.spheres);
    hash = state_hash<Motion>(state.particles.motions, hash);
    hash = state_hash<Load>(state.particles.loads, hash);
    hash = state_hash<std::uint32_t>(state.particles.ids, hash);
    hash = state_hash(std::span<const double>(state.cell.matrix().data(), 9), hash);
    return state_hash(std::span<const double>(state.pressure.data(), 9), hash);
}

}  // namespace jam::test
