// SPDX-License-Identifier: BSD-3-Clause
// One collection's grid: its particles, sorted by bin.
#pragma once

#include "cell/periodic_cell.h"
#include "core/types.h"

#include <vector>

namespace jam {

/// Bins cut the cell evenly along its edges and are numbered along a Morton curve, so that bins
/// near each other in space are near in memory. Particles [begin, end) belong to the collection;
/// those of bin b are [bin_begin[b], bin_begin[b + 1]).
struct CollectionGrid {
    Eigen::Array3i bins = Eigen::Array3i::Zero();
    Index begin = 0;
    Index end = 0;
    double largest_diameter = 0.0;
    double largest_reach = 0.0;      ///< of any member, search margin included
    std::vector<Index> bin_begin;    ///< size bin_count() + 1
    std::vector<Index> curve_place;  ///< by x + nx (y + ny z): the bin's number along the curve
    std::vector<Index> row_major;    ///< the inverse

    Index bin_count() const { return static_cast<Index>(row_major.size()); }
    Index member_count() const { return end - begin; }
    Index bin_at(int x, int y, int z) const {
        return curve_place[static_cast<std::size_t>(x + bins[0] * (y + bins[1] * z))];
    }
    Eigen::Array3i coordinates(Index bin) const;
};

/// Bin of an unwrapped coordinate, and its image: a division that rounds down, of numbers so close
/// that subtracting is faster.
struct WrappedBin {
    int bin;
    int image;
};
inline WrappedBin wrap_bin(int unwrapped, int bins) {
    WrappedBin wrapped{unwrapped, 0};
    for (; wrapped.bin < 0; wrapped.bin += bins) --wrapped.image;
    for (; wrapped.bin >= bins; wrapped.bin -= bins) ++wrapped.image;
    return wrapped;
}

/// Bins of a collection are two largest diameters wide (with their reach), or up to twice as wide
/// where that would leave them nearly empty: below some two dozen members a search spends its time
/// on going from bin to bin. `largest_share` is InteractionReach::of the largest diameter.
double bin_width(double cell_volume, Index member_count, double largest_share);

/// Bins along each edge so that none is narrower than `bin_width`, and that there are at most twice
/// as many as members: memory follows the particles, never the empty volume.
Eigen::Array3i bins_along_edges(const PeriodicCell& cell, double bin_width, Index member_count);

/// Makes the curve of a grid that has the given bins; cheap when they are what they were.
void set_bins(CollectionGrid& grid, const Eigen::Array3i& bins);

/// Bin of wrapped fractional coordinates.
inline Index bin_of(const CollectionGrid& grid, const Vec3& fractional) {
    const auto along = [&](int k) {
        const int bin = static_cast<int>(fractional[k] * grid.bins[k]);
        return bin < grid.bins[k] ? bin : grid.bins[k] - 1;
    };
    return grid.bin_at(along(0), along(1), along(2));
}

}  // namespace jam
