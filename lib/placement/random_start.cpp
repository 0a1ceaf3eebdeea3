// SPDX-License-Identifier: BSD-3-Clause
#include "placement/random_start.h"

#include "core/check.h"
#include "core/random.h"
#include "grids/collection_grid.h"
#include "grids/size_collections.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace jam {

namespace {

constexpr Index none = -1;

/// Spheres already placed, in one linked list a bin, one grid a collection.
class PlacedSpheres {
  public:
    PlacedSpheres(const PeriodicCell& cell, std::span<const double> diameters)
        : cell_(cell),
          diameters_(diameters),
          collections_(geometric_collections(diameters)),
          grids_(static_cast<std::size_t>(collections_.count())),
          first_in_bin_(grids_.size()),
          next_in_bin_(diameters.size(), none),
          centers_(diameters.size()) {
        for (std::size_t c = 0; c < grids_.size(); ++c) {
            CollectionGrid& grid = grids_[c];
            grid.begin = collections_.begin[c];
            grid.end = collections_.begin[c + 1];
            grid.largest_diameter = collections_.upper[c];
            set_bins(grid, bins_along_edges(cell, grid.largest_diameter, grid.member_count()));
            first_in_bin_[c].assign(static_cast<std::size_t>(grid.bin_count()), none);
        }
    }

    /// Spheres are placed largest first, so only as large or larger collections can hold any.
    bool is_free(const Vec3& center, double diameter) const {
        const auto own = static_cast<std::size_t>(collection_of(collections_, diameter));
        for (std::size_t c = grids_.size(); c-- > own;)
            if (overlaps_one_of(c, center, diameter)) return false;
        return true;
    }

    void place(Index sphere, const Vec3& center) {
        const auto at = static_cast<std::size_t>(sphere);
        const auto c = static_cast<std::size_t>(collection_of(collections_, diameters_[at]));
        centers_[at] = center;
        Index& first = first_in_bin_[c][static_cast<std::size_t>(bin_of(grids_[c], center))];
        next_in_bin_[at] = first;
        first = sphere;
    }

    std::vector<Vec3> take_centers() { return std::move(centers_); }

  private:
    bool overlaps_one_of(std::size_t collection, const Vec3& center, double diameter) const {
        const CollectionGrid& grid = grids_[collection];
        const Eigen::Array3d bins = grid.bins.cast<double>();
        const Eigen::Array3d reach =
            0.5 * (diameter + grid.largest_diameter) / cell_.perpendicular_widths().array();
        const Eigen::Array3i low = ((center.array() - reach) * bins).floor().cast<int>();
        const Eigen::Array3i high = ((center.array() + reach) * bins).floor().cast<int>();
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    if (overlaps_in_bin(collection, {x, y, z}, center, diameter)) return true;
        return false;
    }

    bool overlaps_in_bin(std::size_t collection, const Eigen::Array3i& unwrapped,
                         const Vec3& center, double diameter) const {
        const CollectionGrid& grid = grids_[collection];
        const Eigen::Array3d image = (unwrapped.cast<double>() / grid.bins.cast<double>()).floor();
        const Eigen::Array3i bin = unwrapped - image.cast<int>() * grid.bins;
        const auto at = static_cast<std::size_t>(grid.bin_at(bin[0], bin[1], bin[2]));
        for (Index j = first_in_bin_[collection][at]; j != none;
             j = next_in_bin_[static_cast<std::size_t>(j)]) {
            const auto other = static_cast<std::size_t>(j);
            const Vec3 apart = cell_.cartesian(center - centers_[other] - image.matrix());
            const double touching = 0.5 * (diameter + diameters_[other]) * (1.0 + 1e-12);
            if (apart.squaredNorm() < touching * touching) return true;
        }
        return false;
    }

    const PeriodicCell& cell_;
    std::span<const double> diameters_;
    SizeCollections collections_;
    std::vector<CollectionGrid> grids_;
    std::vector<std::vector<Index>> first_in_bin_;
    std::vector<Index> next_in_bin_;
    std::vector<Vec3> centers_;
};

std::vector<Index> largest_first(std::span<const double> diameters) {
    std::vector<Index> order(diameters.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
        return diameters[static_cast<std::size_t>(a)] > diameters[static_cast<std::size_t>(b)];
    });
    return order;
}

PeriodicCell cell_of(std::span<const double> diameters, double volume_fraction) {
    double volume = 0.0;
    for (const double diameter : diameters) volume += sphere_volume(diameter);
    return PeriodicCell::cubic(std::cbrt(volume / volume_fraction));
}

}  // namespace

RandomStart place_at_random(std::span<const double> diameters, const PlacementSettings& settings) {
    require(!diameters.empty(), "start: there are no particles; give at least one");
    require(settings.volume_fraction > 0.0 && settings.volume_fraction < 1.0,
            "start.volume_fraction = {}: must lie above 0 and below 1; 0.3 suits most scenes",
            settings.volume_fraction);
    RandomStart start{cell_of(diameters, settings.volume_fraction), {}};
    const double largest = *std::max_element(diameters.begin(), diameters.end());
    require(start.cell.perpendicular_widths().minCoeff() > largest,
            "start.volume_fraction = {}: the cell would be {:.6g} wide, and the largest sphere is "
            "{:.6g}; use more particles, or a smaller start.volume_fraction",
            settings.volume_fraction, start.cell.perpendicular_widths().minCoeff(), largest);

    PlacedSpheres placed(start.cell, diameters);
    for (const Index sphere : largest_first(diameters)) {
        const double diameter = diameters[static_cast<std::size_t>(sphere)];
        std::uint32_t tries = 0;
        Vec3 center;
        do {
            require(
                tries < settings.most_tries,
                "start.volume_fraction = {}: no free place for a sphere of diameter {:.6g} was "
                "found in {} tries; use a smaller start.volume_fraction (0.3 suits most scenes)",
                settings.volume_fraction, diameter, tries);
            for (std::uint32_t k = 0; k < 3; ++k)
                center[k] = uniform(settings.seed, RandomStream::placement,
                                    static_cast<std::uint64_t>(sphere), 3 * tries + k);
            ++tries;
        } while (!placed.is_free(center, diameter));
        placed.place(sphere, center);
    }
    start.centers = placed.take_centers();
    return start;
}

}  // namespace jam
