// SPDX-License-Identifier: BSD-3-Clause
#include "report/sampling.h"

#include "core/random.h"

#include <cmath>
#include <numbers>

namespace jam {

namespace {

std::uint32_t bits_reversed(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
    x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
    x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
    x = ((x >> 8) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8);
    return (x >> 16) | (x << 16);
}

/// Flips each bit by a hash of the bits below it (S. Laine and T. Karras, 2011). On numbers whose
/// bits are reversed this is Owen's scrambling.
std::uint32_t permuted(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return x;
}

/// Sobol's second dimension with its bits reversed; the first one's are those of the index itself.
/// Bit j is the sum, modulo 2, of the bits k of the index for which the binomial (k over j) is odd:
/// those whose place k holds all bits of j.
std::uint32_t sobol_second_reversed(std::uint32_t index) {
    index ^= (index & 0xaaaaaaaaU) >> 1;
    index ^= (index & 0xccccccccU) >> 2;
    index ^= (index & 0xf0f0f0f0U) >> 4;
    index ^= (index & 0xff00ff00U) >> 8;
    return index ^ (index >> 16);
}

double unit_interval(std::uint32_t bits) {
    return (bits + 0.5) * 0x1p-32;
}

/// Two unit vectors normal to `axis` and to each other (T. Duff et al., "Building an orthonormal
/// basis, revisited", J. Comput. Graph. Tech. 6(1), 2017).
Vec3 turned_to(const Vec3& axis, double x, double y, double z) {
    const double sign = std::copysign(1.0, axis.z());
    const double a = -1.0 / (sign + axis.z());
    const double b = axis.x() * axis.y() * a;
    const Vec3 first(1.0 + sign * axis.x() * axis.x() * a, sign * b, -sign * axis.x());
    const Vec3 second(b, sign + axis.y() * axis.y() * a, -axis.y());
    return x * first + y * second + z * axis;
}

}  // namespace

PixelSamples::PixelSamples(std::uint64_t pixel) : keys_{} {
    for (std::uint32_t use = 0; use < sample_use_count; ++use)
        keys_[use] = random_bits(0, RandomStream::picture, pixel, use);
}

std::array<double, 2> PixelSamples::point(SampleUse use, std::uint32_t number) const {
    const std::uint64_t key = keys_[static_cast<std::size_t>(use)];
    const auto low = static_cast<std::uint32_t>(key);
    const auto high = static_cast<std::uint32_t>(key >> 32);
    // Shuffling the numbers differently for each use keeps what one use draws independent of the
    // others; a nested shuffle keeps every power of two of them an evenly spread set.
    const std::uint32_t index = bits_reversed(permuted(bits_reversed(number), low ^ high));
    return {unit_interval(bits_reversed(permuted(index, low))),
            unit_interval(bits_reversed(permuted(sobol_second_reversed(index), high)))};
}

Vec3 cosine_direction(const std::array<double, 2>& uv, const Vec3& normal) {
    const double radius = std::sqrt(uv[0]);
    const double angle = 2.0 * std::numbers::pi * uv[1];
    return turned_to(normal, radius * std::cos(angle), radius * std::sin(angle),
                     std::sqrt(1.0 - uv[0]));
}

Vec3 cap_direction(const std::array<double, 2>& uv, const Vec3& axis, double cap_cosine) {
    const double z = 1.0 - uv[0] * (1.0 - cap_cosine);
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double angle = 2.0 * std::numbers::pi * uv[1];
    return turned_to(axis, radius * std::cos(angle), radius * std::sin(angle), z);
}

}  // namespace jam
