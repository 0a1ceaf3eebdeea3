// SPDX-License-Identifier: BSD-3-Clause
// Which spheres lie near which: half lists by rows, every pair with its periodic image.
#pragma once

#include "core/types.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace jam {

/// Images -1, 0 or 1 along each edge, as one number.
inline constexpr std::uint32_t image_count = 27;
constexpr std::uint32_t image_code(int x, int y, int z) {
    return static_cast<std::uint32_t>((x + 1) + 3 * (y + 1) + 9 * (z + 1));
}
inline constexpr std::uint32_t home_image = image_code(0, 0, 0);

/// One listed neighbor: particle index and image in one word (27 bits and 5 bits).
///
/// The vector from the neighbor's image to the particle that lists it is
/// h (s_i - s_j - image), h the cell matrix and s the stored fractional centers. An image is -1, 0
/// or 1 along each edge: enough for any cell whose perpendicular widths are at least the largest
/// interaction distance, which find_neighbors requires.
class Neighbor {
  public:
    static constexpr int index_bits = 27;
    static constexpr std::uint32_t index_mask = (1u << index_bits) - 1;

    Neighbor() = default;
    Neighbor(Index particle, std::uint32_t image)
        : word_(static_cast<std::uint32_t>(particle) | image << index_bits) {}

    Index particle() const { return static_cast<Index>(word_ & index_mask); }
    std::uint32_t word() const { return word_; }
    static Neighbor from_word(std::uint32_t word) {
        Neighbor neighbor;
        neighbor.word_ = word;
        return neighbor;
    }
    std::uint32_t image() const { return word_ >> index_bits; }
    friend bool operator==(Neighbor, Neighbor) = default;

  private:
    std::uint32_t word_ = 0;
};

/// Image of each code, as doubles ready for the arithmetic.
struct alignas(32) ImageShift {
    double x, y, z, padding;
};
extern const std::array<ImageShift, image_count> image_shifts;

Image image_of(std::uint32_t code);

/// Every near pair once. Row i holds the neighbors that particle i lists; a pair stands in the row
/// of one of its two particles, and which one is the builder's choice. A particle may list itself
/// through an image.
struct NeighborList {
    std::vector<Count> row_begin;     ///< size N + 1
    std::vector<Neighbor> neighbors;  ///< size row_begin[N]

    Index particle_count() const { return static_cast<Index>(row_begin.size()) - 1; }
    Count pair_count() const { return row_begin.empty() ? 0 : row_begin.back(); }
    Count pairs_of_rows(Index begin, Index end) const {
        return row_begin[static_cast<std::size_t>(end)] -
               row_begin[static_cast<std::size_t>(begin)];
    }
    std::span<const Neighbor> row(Index i) const {
        const auto at = static_cast<std::size_t>(i);
        return {neighbors.data() + row_begin[at], neighbors.data() + row_begin[at + 1]};
    }
};

}  // namespace jam
