// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/candidate_buffer.h"

#include <algorithm>
#include <bit>

namespace jam {

/// Those of sixteen words whose bit is set, one after the other; returns where the next one goes.
/// Up to `to + 16` may be overwritten.
static std::uint32_t* copy_lanes(const std::uint32_t* words, std::uint32_t bits,
                                 std::uint32_t* to) {
#if defined(__AVX512F__)
    // No branch on which candidates are near: nobody could predict it.
    const __m512i kept =
        _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), _mm512_loadu_si512(words));
    _mm512_storeu_si512(to, kept);
    return to + std::popcount(bits & 0xffffu);
#else
    for (; bits != 0; bits &= bits - 1) *to++ = words[std::countr_zero(bits)];
    return to;
#endif
}

void CandidateBuffer::reserve(int count) {
    const auto needed = static_cast<std::size_t>(count + 2 * lane_count);
    if (word_.size() >= needed) return;
    const std::size_t size = std::max(needed, 2 * word_.size());
    for (auto* column : {&x_, &y_, &z_, &reach_}) column->resize(size);
    word_.resize(size);
}

void CandidateBuffer::append_all(const LocalSpheres& local, Index begin, Index end) {
    const int count = end - begin;
    reserve(size_ + count);
    const auto to = static_cast<std::size_t>(size_);
    const auto from = static_cast<std::size_t>(begin);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        x_[to + k] = local.x[from + k];
        y_[to + k] = local.y[from + k];
        z_[to + k] = local.z[from + k];
        reach_[to + k] = local.reach[from + k];
        word_[to + k] = Neighbor(begin + static_cast<Index>(k), home_image).word();
    }
    size_ += count;
}

std::size_t CandidateBuffer::copy_near(int member, std::uint32_t* to) const {
    const LocalSphere center = sphere(member);
    const std::uint32_t* const begin = to;
    const int first = (member + 1) & ~(lane_count - 1);
    std::uint32_t behind = ~0u << (member + 1 - first);
    for (int at = first; at < size_; at += lane_count, behind = ~0u) {
        const std::uint32_t near = behind & near_lanes(x_.data() + at, y_.data() + at,
                                                       z_.data() + at, reach_.data() + at, center);
        to = copy_lanes(word_.data() + at, near, to);
    }
    return static_cast<std::size_t>(to - begin);
}

#if defined(__AVX512F__)

void CandidateBuffer::append_near(const LocalSpheres& local, Index begin, Index end,
                                  const LocalSphere& offset, const LocalSphere& bounds,
                                  std::uint32_t image) {
    reserve(size_ + (end - begin));
    // The bounds are moved instead of the candidates; only those kept are moved.
    const LocalSphere moved{bounds.x - offset.x, bounds.y - offset.y, bounds.z - offset.z,
                            bounds.reach};
    const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    for (Index first = begin; first < end; first += lane_count) {
        const auto from = static_cast<std::size_t>(first);
        const float* const x = local.x.data() + from;
        const float* const y = local.y.data() + from;
        const float* const z = local.z.data() + from;
        const float* const reach = local.reach.data() + from;
        std::uint32_t near = near_lanes(x, y, z, reach, moved);
        if (end - first < lane_count) near &= (1u << (end - first)) - 1u;
        if (near == 0) continue;
        const auto mask = static_cast<__mmask16>(near);
        const auto to = static_cast<std::size_t>(size_);
        const auto keep = [&](const float* values, float shift, std::vector<float>& column) {
            const __m512 kept = _mm512_maskz_compress_ps(mask, _mm512_loadu_ps(values));
            _mm512_storeu_ps(column.data() + to, _mm512_add_ps(kept, _mm512_set1_ps(shift)));
        };
        keep(x, offset.x, x_);
        keep(y, offset.y, y_);
        keep(z, offset.z, z_);
        keep(reach, 0.0f, reach_);
        const std::uint32_t first_word = Neighbor(first, image).word();
        const __m512i words =
            _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first_word)), lane);
        _mm512_storeu_si512(word_.data() + to, _mm512_maskz_compress_epi32(mask, words));
        size_ += std::popcount(near);
    }
}

#else

void CandidateBuffer::append_near(const LocalSpheres& local, Index begin, Index end,
                                  const LocalSphere& offset, const LocalSphere& bounds,
                                  std::uint32_t image) {
    reserve(size_ + (end - begin));
    const LocalSphere moved{bounds.x - offset.x, bounds.y - offset.y, bounds.z - offset.z,
                            bounds.reach};
    for (Index first = begin; first < end; first += lane_count) {
        const auto from = static_cast<std::size_t>(first);
        std::uint32_t near = near_lanes(local.x.data() + from, local.y.data() + from,
                                        local.z.data() + from, local.reach.data() + from, moved);
        if (end - first < lane_count) near &= (1u << (end - first)) - 1u;
        for (; near != 0; near &= near - 1) {
            const int lane = std::countr_zero(near);
            const auto k = from + static_cast<std::size_t>(lane);
            const auto to = static_cast<std::size_t>(size_++);
            x_[to] = local.x[k] + offset.x;
            y_[to] = local.y[k] + offset.y;
            z_[to] = local.z[k] + offset.z;
            reach_[to] = local.reach[k];
            word_[to] = Neighbor(first + lane, image).word();
        }
    }
}

#endif

void CandidateBuffer::pad() {
    reserve(size_);
    const auto end = static_cast<std::size_t>(size_);
    std::fill_n(x_.begin() + static_cast<std::ptrdiff_t>(end), lane_count,
                std::numeric_limits<float>::infinity());
    for (auto* column : {&y_, &z_, &reach_})
        std::fill_n(column->begin() + static_cast<std::ptrdiff_t>(end), lane_count, 0.0f);
}

}  // namespace jam
