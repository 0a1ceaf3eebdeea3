// SPDX-License-Identifier: BSD-3-Clause
// Short vectors for the hot loops, in the compiler's own vector types, so that one source serves
// every instruction set.
#pragma once

#include <cstdint>
#include <cstring>

namespace jam {

/// Three coordinates and one scalar of a particle, added and scaled at once.
using Double4 = double __attribute__((vector_size(32)));

/// Reads a 32-byte record (Sphere, Motion, Load) as four numbers.
template <typename Record>
Double4 load4(const Record& record) {
    static_assert(sizeof(Record) == sizeof(Double4));
    Double4 values;
    std::memcpy(&values, static_cast<const void*>(&record), sizeof values);
    return values;
}

template <typename Record>
void store4(const Double4& values, Record& record) {
    static_assert(sizeof(Record) == sizeof(Double4));
    std::memcpy(static_cast<void*>(&record), &values, sizeof values);
}

/// Sixteen single-precision numbers and what a comparison of them gives (-1 true, 0 false).
inline constexpr int lane_count = 16;
using Float16 = float __attribute__((vector_size(64)));
using Mask16 = std::int32_t __attribute__((vector_size(64)));

inline Float16 load_lanes(const float* from) {
    Float16 lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

}  // namespace jam
