// SPDX-License-Identifier: BSD-3-Clause
// Counter-based random numbers: a value depends on (seed, stream, id, draw) and on nothing else, so
// the same particle gets the same number whatever the thread count or the order of the loops.
#pragma once

#include <cstdint>

namespace jam {

/// Every use of randomness has its own stream, so that adding one never shifts another. The numbers
/// are part of what makes a seed reproducible: never reuse or renumber one.
enum class RandomStream : std::uint32_t {
    diameters = 1,
    placement = 2,
    rods = 3,
    bootstrap = 4,
    tests = 5,
    picture = 6,
    stability = 7,
};

/// Uniform double in the open interval (0, 1), with 53 random bits (Philox 4x32-10, Salmon et al.
/// 2011, through Random123).
double uniform(std::uint64_t seed, RandomStream stream, std::uint64_t id, std::uint32_t draw = 0);

/// 64 random bits from the same generator.
std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, std::uint64_t id,
                          std::uint32_t draw = 0);

}  // namespace jam
