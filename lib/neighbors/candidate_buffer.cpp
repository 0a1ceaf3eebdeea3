// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/candidate_buffer.h"

#include <algorithm>
#include <bit>

namespace jam {

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
        to += store_packed(load_lanes(word_.data() + at), near, to);
    }
    return static_cast<std::size_t>(to - begin);
}

void CandidateBuffer::append_near(const LocalSpheres& local, Index begin, Index end,
                                  const LocalSphere& offset, const LocalSphere& bounds,
                                  std::uint32_t image) {
    reserve(size_ + (end - begin));
    // The bounds are moved instead of the candidates; only those kept are moved.
    const LocalSphere moved{bounds.x - offset.x, bounds.y - offset.y, bounds.z - offset.z,
                            bounds.reach};
    constexpr Word16 lane = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    for (Index first = begin; first < end; first += lane_count) {
        const auto from = static_cast<std::size_t>(first);
        const float* const x = local.x.data() + from;
        const float* const y = local.y.data() + from;
        const float* const z = local.z.data() + from;
        const float* const reach = local.reach.data() + from;
        std::uint32_t near = near_lanes(x, y, z, reach, moved);
        if (end - first < lane_count) near &= (1u << (end - first)) - 1u;
        if (near == 0) continue;
        const auto to = static_cast<std::size_t>(size_);
        store_packed(load_lanes(x) + offset.x, near, x_.data() + to);
        store_packed(load_lanes(y) + offset.y, near, y_.data() + to);
        store_packed(load_lanes(z) + offset.z, near, z_.data() + to);
        store_packed(load_lanes(reach), near, reach_.data() + to);
        store_packed(lane + Neighbor(first, image).word(), near, word_.data() + to);
        size_ += std::popcount(near);
    }
}

void CandidateBuffer::pad() {
    reserve(size_);
    const auto end = static_cast<std::size_t>(size_);
    std::fill_n(x_.begin() + static_cast<std::ptrdiff_t>(end), lane_count,
                std::numeric_limits<float>::infinity());
    for (auto* column : {&y_, &z_, &reach_})
        std::fill_n(column->begin() + static_cast<std::ptrdiff_t>(end), lane_count, 0.0f);
}

}  // namespace jam
