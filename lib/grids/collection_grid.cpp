// SPDX-License-Identifier: BSD-3-Clause
#include "grids/collection_grid.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace jam {

namespace {

/// The bits of `value` (below 2^21) set three apart.
std::uint64_t spread(std::uint64_t value) {
    std::uint64_t spread_bits = 0;
    for (int bit = 0; bit < 21; ++bit) spread_bits |= (value >> bit & 1) << (3 * bit);
    return spread_bits;
}

struct CurveBin {
    std::uint64_t morton_code;
    Index row_major;
};

}  // namespace

Eigen::Array3i CollectionGrid::coordinates(Index bin) const {
    const Index at = row_major[static_cast<std::size_t>(bin)];
    return {at % bins[0], at / bins[0] % bins[1], at / (bins[0] * bins[1])};
}

double bin_width(double cell_volume, Index member_count, double largest_share) {
    constexpr double width_in_diameters = 2.0;
    constexpr double least_occupancy = 24.0;
    const double usual = width_in_diameters * 2.0 * largest_share;
    return std::clamp(std::cbrt(least_occupancy * cell_volume / member_count), usual, 2.0 * usual);
}

Eigen::Array3i bins_along_edges(const PeriodicCell& cell, double bin_width, Index member_count) {
    const double most = std::max(1.0, 2.0 * member_count);
    double width = bin_width;
    for (;;) {
        const Eigen::Array3d along = (cell.perpendicular_widths().array() / width).floor().max(1.0);
        if (along.prod() <= most) return along.cast<int>();
        width *= std::max(1.01, std::cbrt(along.prod() / most));
    }
}

void set_bins(CollectionGrid& grid, const Eigen::Array3i& bins) {
    if ((grid.bins == bins).all()) return;
    grid.bins = bins;
    const auto count = static_cast<std::size_t>(bins.prod());
    std::vector<CurveBin> curve(count);
    for (std::size_t at = 0; at < count; ++at) {
        const auto row_major = static_cast<Index>(at);
        const auto x = static_cast<std::uint64_t>(row_major % bins[0]);
        const auto y = static_cast<std::uint64_t>(row_major / bins[0] % bins[1]);
        const auto z = static_cast<std::uint64_t>(row_major / (bins[0] * bins[1]));
        curve[at] = {spread(x) | spread(y) << 1 | spread(z) << 2, row_major};
    }
    sort_total_order(
        curve, [](const CurveBin& a, const CurveBin& b) { return a.morton_code < b.morton_code; });
    grid.curve_place.resize(count);
    grid.row_major.resize(count);
    for (std::size_t place = 0; place < count; ++place) {
        grid.row_major[place] = curve[place].row_major;
        grid.curve_place[static_cast<std::size_t>(curve[place].row_major)] =
            static_cast<Index>(place);
    }
}

}  // namespace jam
