// SPDX-License-Identifier: BSD-3-Clause
// Well-spread random points for the light of a pixel: they depend on the pixel, on what they are
// used for and on their number, never on the order in which pixels are drawn.
#pragma once

#include "core/types.h"

#include <array>
#include <cstdint>

namespace jam {

/// What a point of the unit square decides.
enum class SampleUse : std::uint32_t { pixel, sky, lamp };
inline constexpr std::size_t sample_use_count = 3;

/// The sequences of one pixel: Sobol's first two dimensions, shuffled and Owen-scrambled by hashes
/// (B. Burley, "Practical hash-based Owen scrambling", J. Comput. Graph. Tech. 9(4), 2020).
class PixelSamples {
  public:
    explicit PixelSamples(std::uint64_t pixel);

    /// Point `number` of the unit square; any power of two of them fill it evenly.
    std::array<double, 2> point(SampleUse use, std::uint32_t number) const;

  private:
    std::array<std::uint64_t, sample_use_count> keys_;
};

/// The unit vector at (u, v), spread over the half-space of `normal` with the density of its
/// cosine.
Vec3 cosine_direction(const std::array<double, 2>& uv, const Vec3& normal);

/// A unit vector spread evenly over the cap around `axis` whose edge has the cosine `cap_cosine`.
Vec3 cap_direction(const std::array<double, 2>& uv, const Vec3& axis, double cap_cosine);

}  // namespace jam
