// SPDX-License-Identifier: BSD-3-Clause
// The candidates of one bin in single precision, sixteen tested at a time.
#pragma once

#include "core/lanes.h"
#include "core/types.h"
#include "grids/grid_hierarchy.h"
#include "neighbors/neighbor_list.h"

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include <cstdint>
#include <limits>
#include <vector>

namespace jam {

/// A sphere in the local coordinates of the searching bin; `reach` bounds distances from its
/// center.
struct LocalSphere {
    float x, y, z, reach;
};

/// Bit k is set where sphere k of eight comes within reach of `center`. No fused multiply-add, so
/// that every instruction set gives the same bits.
inline std::uint32_t near_eight(const float* x, const float* y, const float* z, const float* reach,
                                const LocalSphere& center) {
    const Float8 dx = load_eight(x) - center.x;
    const Float8 dy = load_eight(y) - center.y;
    const Float8 dz = load_eight(z) - center.z;
    const Float8 cut = load_eight(reach) + center.reach;
    return bits_of_eight((dx * dx + dy * dy) + dz * dz <= cut * cut);
}

/// The same of sixteen.
inline std::uint32_t near_lanes(const float* x, const float* y, const float* z, const float* reach,
                                const LocalSphere& center) {
#if defined(__AVX512F__)
    const __m512 dx = _mm512_sub_ps(_mm512_loadu_ps(x), _mm512_set1_ps(center.x));
    const __m512 dy = _mm512_sub_ps(_mm512_loadu_ps(y), _mm512_set1_ps(center.y));
    const __m512 dz = _mm512_sub_ps(_mm512_loadu_ps(z), _mm512_set1_ps(center.z));
    const __m512 cut = _mm512_add_ps(_mm512_loadu_ps(reach), _mm512_set1_ps(center.reach));
    const __m512 distance_squared = _mm512_add_ps(
        _mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy)), _mm512_mul_ps(dz, dz));
    return _mm512_cmp_ps_mask(distance_squared, _mm512_mul_ps(cut, cut), _CMP_LE_OQ);
#else
    return near_eight(x, y, z, reach, center) | near_eight(x + 8, y + 8, z + 8, reach + 8, center)
                                                    << 8;
#endif
}

/// Candidates gathered for one bin: structure of arrays, padded so that whole vectors can be read.
class CandidateBuffer {
  public:
    void clear() { size_ = 0; }
    int size() const { return size_; }
    LocalSphere sphere(int at) const {
        const auto k = static_cast<std::size_t>(at);
        return {x_[k], y_[k], z_[k], reach_[k]};
    }

    /// Appends particles [begin, end) of one bin, moved by `offset`, that come within reach of
    /// `bounds`.
    void append_near(const LocalSpheres& local, Index begin, Index end, const LocalSphere& offset,
                     const LocalSphere& bounds, std::uint32_t image);

    /// Appends particles [begin, end) as they are.
    void append_all(const LocalSpheres& local, Index begin, Index end);

    /// Fills the last vector up with spheres that are near nothing.
    void pad();

    /// Writes the words of the spheres that stand behind `member` and are near it to `to`, which
    /// has room for size() + 16; returns how many. The buffer must be padded.
    std::size_t copy_near(int member, std::uint32_t* to) const;

  private:
    void reserve(int count);

    std::vector<float> x_, y_, z_, reach_;
    std::vector<std::uint32_t> word_;
    int size_ = 0;
};

}  // namespace jam
