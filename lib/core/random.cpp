// SPDX-License-Identifier: BSD-3-Clause
#include "core/random.h"

#include <Random123/philox.h>

namespace jam {

std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, std::uint64_t id,
                          std::uint32_t draw) {
    using Philox = r123::Philox4x32;
    const Philox::key_type key = {
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const Philox::ctr_type counter = {{static_cast<std::uint32_t>(id),
                                       static_cast<std::uint32_t>(id >> 32), draw,
                                       static_cast<std::uint32_t>(stream)}};
    const Philox::ctr_type bits = Philox{}(counter, key);
    return (std::uint64_t{bits[0]} << 32) | bits[1];
}

double uniform(std::uint64_t seed, RandomStream stream, std::uint64_t id, std::uint32_t draw) {
    const std::uint64_t top_53_bits = random_bits(seed, stream, id, draw) >> 11;
    return (static_cast<double>(top_53_bits) + 0.5) * 0x1p-53;
}

}  // namespace jam
