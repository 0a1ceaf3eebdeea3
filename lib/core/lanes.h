// SPDX-License-Identifier: BSD-3-Clause
// Short vectors for the hot loops, in the compiler's own vector types, so that one source serves
// every instruction set.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace jam {

/// Three coordinates and one scalar of a particle, added and scaled at once.
using Double4 = double __attribute__((vector_size(32)));

/// The same wherever eight bytes are aligned, over memory of any type: read and written at once on
/// every machine, where a compiler may take memcpy to pieces that the processor has to join.
using Double4InMemory = Double4 __attribute__((aligned(8), may_alias));

/// Reads a 32-byte record (Sphere, Motion, Load) as four numbers.
template <typename Record>
Double4 load4(const Record& record) {
    static_assert(sizeof(Record) == sizeof(Double4));
    static_assert(alignof(Record) >= alignof(Double4InMemory));
    return *reinterpret_cast<const Double4InMemory*>(&record);
}

/// Reads a 64-byte record as twice four numbers.
template <typename Record>
std::array<Double4, 2> load8(const Record& record) {
    static_assert(sizeof(Record) == 2 * sizeof(Double4));
    static_assert(alignof(Record) >= alignof(Double4InMemory));
    const auto* halves = reinterpret_cast<const Double4InMemory*>(&record);
    return {halves[0], halves[1]};
}

template <typename Record>
void store4(const Double4& values, Record& record) {
    static_assert(sizeof(Record) == sizeof(Double4));
    static_assert(alignof(Record) >= alignof(Double4InMemory));
    *reinterpret_cast<Double4InMemory*>(&record) = values;
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
#ifdef __AVX__
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

/// For each choice of four things the places of the chosen ones, in order, then anything.
struct alignas(16) PackedOrder {
    std::array<std::int32_t, 4> place{};
};
inline constexpr std::array<PackedOrder, 16> packed_orders = [] {
    std::array<PackedOrder, 16> orders;
    for (unsigned bits = 0; bits < 16; ++bits) {
        std::size_t end = 0;
        for (int k = 0; k < 4; ++k)
            if ((bits >> k & 1u) != 0) orders[bits].place[end++] = k;
    }
    return orders;
}();

/// Writes those of four 32-bit records whose bits are set, one after the other, and returns how
/// many they are. `to` has room for four: what is behind them is overwritten with anything.
template <typename Record>
std::size_t store_packed(const Record* four, unsigned bits, Record* to) {
    static_assert(sizeof(Record) == 4);
#ifdef __AVX__
    const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(&packed_orders[bits]));
    const __m128 records = _mm_loadu_ps(reinterpret_cast<const float*>(four));
    _mm_storeu_ps(reinterpret_cast<float*>(to), _mm_permutevar_ps(records, order));
#else
    Record* end = to;
    for (unsigned k = 0; k < 4; ++k) {
        *end = four[k];
        end += bits >> k & 1u;
    }
#endif
    return static_cast<std::size_t>(std::popcount(bits));
}

/// Writes four numbers one after the other.
inline void store_lanes(const Double4& values, double* to) {
    *reinterpret_cast<Double4InMemory*>(to) = values;
}

/// Four records side by side: x holds the first number of each, w the last.
struct Columns4 {
    Double4 x, y, z, w;
};

/// x^2 + y^2 + z^2 of each.
inline Double4 squared_length(const Columns4& v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

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

/// Eight single-precision numbers and what a comparison of them gives (-1 true, 0 false).
using Float8 = float __attribute__((vector_size(32)));
using Mask8 = std::int32_t __attribute__((vector_size(32)));

inline Float8 load_eight(const float* from) {
    using InMemory = Float8 __attribute__((aligned(4), may_alias));
    return *reinterpret_cast<const InMemory*>(from);
}

/// One bit for each that is true, the first the lowest. No overload of bits_of: compilers differ in
/// what type a comparison of doubles has, and would not know which is meant.
inline std::uint32_t bits_of_eight(const Mask8& mask) {
#ifdef __AVX__
    return static_cast<std::uint32_t>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
#else
    std::uint32_t bits = 0;
    for (int k = 0; k < 8; ++k) bits |= (static_cast<std::uint32_t>(mask[k]) & 1u) << k;
    return bits;
#endif
}

/// Sixteen single-precision numbers. Without AVX-512 comparisons of them are taken to pieces by
/// GCC: those are better made of eight.
inline constexpr int lane_count = 16;
using Float16 = float __attribute__((vector_size(64)));

/// Sixteen 32-bit words.
using Word16 = std::uint32_t __attribute__((vector_size(64)));

inline Float16 load_lanes(const float* from) {
    using InMemory = Float16 __attribute__((aligned(4), may_alias));
    return *reinterpret_cast<const InMemory*>(from);
}
inline Word16 load_lanes(const std::uint32_t* from) {
    using InMemory = Word16 __attribute__((aligned(4), may_alias));
    return *reinterpret_cast<const InMemory*>(from);
}

/// Writes those of sixteen numbers or words whose bits are set, one after the other, and returns
/// how many they are. `to` has room for sixteen: what is behind them is overwritten with anything.
template <typename Lanes, typename Value>
std::size_t store_packed(const Lanes& lanes, std::uint32_t bits, Value* to) {
    static_assert(sizeof(Lanes) == 64 && sizeof(Value) == 4);
#if defined(__AVX512F__)
    // No branch on which are chosen: nobody could predict it.
    const auto packed =
        _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), std::bit_cast<__m512i>(lanes));
    _mm512_storeu_si512(to, packed);
#else
    using Values = std::array<Value, lane_count>;
    const auto values = std::bit_cast<Values>(lanes);
    for (std::uint32_t left = bits & 0xffffu; left != 0; left &= left - 1)
        *to++ = values[static_cast<std::size_t>(std::countr_zero(left))];
#endif
    return static_cast<std::size_t>(std::popcount(bits & 0xffffu));
}

}  // namespace jam
