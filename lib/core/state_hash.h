// SPDX-License-Identifier: BSD-3-Clause
// A hash of raw bytes, by which tests and benchmarks tell whether two states are the same bits.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace jam {

/// FNV-1a over 8-byte words (the rest byte by byte). `seed` chains several arrays into one hash.
template <typename T>
std::uint64_t state_hash(std::span<const T> values, std::uint64_t seed = 0xcbf29ce484222325) {
    static_assert(std::is_trivially_copyable_v<T> || std::is_standard_layout_v<T>);
    constexpr std::uint64_t prime = 0x100000001b3;
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    const std::size_t size = values.size_bytes();
    std::uint64_t hash = seed;
    std::size_t at = 0;
    for (; at + 8 <= size; at += 8) {
        std::uint64_t word;
        std::memcpy(&word, bytes + at, 8);
        hash = (hash ^ word) * prime;
        hash ^= hash >> 32;
    }
    for (; at < size; ++at) hash = (hash ^ bytes[at]) * prime;
    return hash;
}

}  // namespace jam
