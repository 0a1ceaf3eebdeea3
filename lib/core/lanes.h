// SPDX-License-Identifier: BSD-3-Clause
// Short vectors for the hot loops, in the compiler's own vector types, so that one source serves
// every instruction set.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#ifdef __AVX512VL__
#include <immintrin.h>
#endif

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

/// How many records before its turn one is asked for.
inline constexpr std::size_t records_ahead = 16;

/// Asks for the memory of a record that is read, or written, soon: which come next is known from a
/// list, but where they lie cannot be guessed.
template <typename Record>
void expect_read(const Record& record) {
    __builtin_prefetch(&record, 0);
}
template <typename Record>
void expect_write(const Record& record) {
    __builtin_prefetch(&record, 1);
}

/// Calls body(k) for k from begin to end, and expect(k) records_ahead turns before it.
template <typename Expect, typename Body>
void for_each_expected(std::size_t begin, std::size_t end, Expect&& expect, Body&& body) {
    for (std::size_t k = begin; k < end; ++k) {
        if (k + records_ahead < end) expect(k + records_ahead);
        body(k);
    }
}

/// The first three of one, the fourth of another.
inline Double4 with_fourth_of(const Double4& first_three, const Double4& fourth) {
    return __builtin_shufflevector(first_three, fourth, 0, 1, 2, 7);
}

/// What a comparison of four numbers gives: -1 true, 0 false.
using Mask4 = std::int64_t __attribute__((vector_size(32)));

/// One bit for each that is true, the first the lowest.
inline unsigned bits_of(const Mask4& mask) {
#ifdef __AVX512VL__
    return static_cast<unsigned>(_mm256_movemask_pd(std::bit_cast<__m256d>(mask)));
#else
    unsigned bits = 0;
    for (unsigned k = 0; k < 4; ++k) bits |= mask[k] != 0 ? 1u << k : 0u;
    return bits;
#endif
}

/// The bits of the first ones.
inline unsigned bits_of_first(int count) {
    return (1u << count) - 1;
}

/// Writes those of four numbers whose bits are set, one after the other. `to` has room for four:
/// what is behind them is overwritten with anything.
inline void store_packed(const Double4& values, unsigned bits, double* to) {
#ifdef __AVX512VL__
    _mm256_storeu_pd(to, _mm256_maskz_compress_pd(static_cast<__mmask8>(bits), values));
#else
    for (unsigned k = 0; k < 4; ++k) {
        *to = values[k];
        to += bits >> k & 1u;
    }
#endif
}

/// Four records side by side: x holds the first number of each, w the last.
struct Columns4 {
    Double4 x, y, z, w;
};

/// Records into columns, or columns into records.
inline Columns4 transposed(const Columns4& m) {
    const Double4 even_low = __builtin_shufflevector(m.x, m.y, 0, 4, 2, 6);
    const Double4 odd_low = __builtin_shufflevector(m.x, m.y, 1, 5, 3, 7);
    const Double4 even_high = __builtin_shufflevector(m.z, m.w, 0, 4, 2, 6);
    const Double4 odd_high = __builtin_shufflevector(m.z, m.w, 1, 5, 3, 7);
    return {__builtin_shufflevector(even_low, even_high, 0, 1, 4, 5),
            __builtin_shufflevector(odd_low, odd_high, 0, 1, 4, 5),
            __builtin_shufflevector(even_low, even_high, 2, 3, 6, 7),
            __builtin_shufflevector(odd_low, odd_high, 2, 3, 6, 7)};
}

/// Calls body(first of four, count) over all of them, in order. The last ones may be fewer: then
/// the first of them stands in the other places.
template <typename Record, typename Body>
void for_each_four(std::span<const Record> records, Body&& body) {
    constexpr std::size_t four = 4;
    std::size_t begin = 0;
    for (; begin + four <= records.size(); begin += four) body(&records[begin], 4);
    if (begin == records.size()) return;
    std::array<Record, four> last;
    last.fill(records[begin]);
    std::copy(records.begin() + static_cast<std::ptrdiff_t>(begin), records.end(), last.begin());
    body(last.data(), static_cast<int>(records.size() - begin));
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
