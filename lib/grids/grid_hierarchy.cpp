// SPDX-License-Identifier: BSD-3-Clause
#include "grids/grid_hierarchy.h"

#include "core/check.h"
#include "core/particle_limit.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace jam {

namespace {

constexpr Count particles_per_block = 4096;

/// Single precision rounds a coordinate of size c by at most c 2^-24; local coordinates, offsets of
/// bins and their sums and squares each add some of it: 64 times 2^-24 of the largest extent covers
/// them all.
constexpr double rounding_margin = 0x1p-18;

float reach_in_single_precision(const InteractionReach& reach, double diameter, double bin_extent) {
    const double share = reach.of(diameter);
    return static_cast<float>(share + rounding_margin * (share + bin_extent));
}

/// Half the diagonal of a bin and the reach of its members: no local coordinate that the search
/// forms with this grid is longer than four times this.
double extent_of_bins(const PeriodicCell& cell, const CollectionGrid& grid,
                      const InteractionReach& reach) {
    const Vec3 bin = (1.0 / grid.bins.cast<double>()).matrix();
    return 0.5 * (cell.matrix().cwiseAbs() * bin).norm() + 2.0 * reach.of(grid.largest_diameter);
}

}  // namespace

GridHierarchy::GridHierarchy(SizeCollections collections) : collections_(std::move(collections)) {
    for (int c = 0; c < collections_.count(); ++c) {
        const auto at = static_cast<std::size_t>(c);
        CollectionGrid& grid = grids_.emplace_back();
        grid.begin = collections_.begin[at];
        grid.end = collections_.begin[at + 1];
        grid.largest_diameter = collections_.upper[at];
    }
    const auto count = static_cast<std::size_t>(collections_.begin.back());
    require(collections_.begin.back() <= max_particle_count,
            "particles: {} of them; at most {} fit one machine's neighbor list", count,
            max_particle_count);
    for (auto* column : {&local_.x, &local_.y, &local_.z, &local_.reach})
        column->resize(count + 16);  // whole vectors may be read past the end
    bin_of_particle_.resize(count);
    order_.resize(count);
}

void GridHierarchy::group(Particles& particles) const {
    const Index count = particles.size();
    std::vector<Index> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    std::vector<int> collection(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        collection[i] = collection_of(collections_, particles.spheres[i].diameter);
    const auto& ids = particles.ids;
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        const auto i = static_cast<std::size_t>(a);
        const auto j = static_cast<std::size_t>(b);
        return std::pair(collection[i], ids[i]) < std::pair(collection[j], ids[j]);
    });
    const Particles before = particles;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto from = static_cast<std::size_t>(order[i]);
        particles.spheres[i] = before.spheres[from];
        particles.motions[i] = before.motions[from];
        particles.ids[i] = before.ids[from];
    }
}

std::vector<TaskGraph::Task> GridHierarchy::add_sorting(TaskGraph& graph, const PeriodicCell& cell,
                                                        const InteractionReach& reach,
                                                        Particles& particles, Particles& sorted) {
    const double largest_reach = 2.0 * reach.of(collections_.upper.back());
    require(cell.perpendicular_widths().minCoeff() >= largest_reach,
            "cell: its narrowest width is {:.6g}, the largest interaction distance {:.6g}; a cell "
            "must be at least as wide as its largest sphere reaches: use more particles "
            "(sizes.count), or a smaller sizes.size_ratio",
            cell.perpendicular_widths().minCoeff(), largest_reach);
    cell_ = cell;
    reach_ = reach;
    const auto count = static_cast<std::size_t>(particles.size());
    sorted.spheres.resize(count);
    sorted.motions.resize(count);
    sorted.loads.resize(count);
    sorted.ids.resize(count);
    std::vector<TaskGraph::Task> tasks;
    tasks.reserve(grids_.size());
    for (int c = 0; c < collections_.count(); ++c)
        tasks.push_back(
            graph.add([this, c, &particles, &sorted] { sort_collection(c, particles, sorted); }));
    return tasks;
}

void GridHierarchy::sort_collection(int collection, Particles& particles, Particles& sorted) {
    CollectionGrid& grid = grids_[static_cast<std::size_t>(collection)];
    place_bins(grid);
    const Count members = grid.member_count();
    const auto begin = static_cast<std::size_t>(grid.begin);
    const std::span bins(bin_of_particle_.data() + begin, static_cast<std::size_t>(members));
    const std::span order(order_.data() + begin, static_cast<std::size_t>(members));
    for_each_block(members, particles_per_block, [&](Count, Count first, Count last) {
        for (Count i = first; i < last; ++i) {
            Vec3& center = particles.spheres[begin + static_cast<std::size_t>(i)].center;
            center = wrapped(center);
            bins[static_cast<std::size_t>(i)] = bin_of(grid, center);
        }
    });
    counting_sort(bins, grid.bin_count(), grid.bin_begin, order);
    for (Index& bin_begin : grid.bin_begin) bin_begin += grid.begin;
    move_members(grid, particles, sorted);
}

void GridHierarchy::place_bins(CollectionGrid& grid) {
    const double width =
        bin_width(cell_.volume(), grid.member_count(), reach_.of(grid.largest_diameter));
    set_bins(grid, bins_along_edges(cell_, width, grid.member_count()));
    grid.largest_reach = reach_in_single_precision(reach_, grid.largest_diameter,
                                                   extent_of_bins(cell_, grid, reach_));
}

void GridHierarchy::move_members(const CollectionGrid& grid, const Particles& particles,
                                 Particles& sorted) {
    const Vec3 bin_size = (1.0 / grid.bins.cast<double>()).matrix();
    const double extent = extent_of_bins(cell_, grid, reach_);
    for_each_block(grid.bin_count(), 64, [&](Count, Count first_bin, Count last_bin) {
        for (auto bin = static_cast<Index>(first_bin); bin < last_bin; ++bin) {
            const Vec3 center =
                (grid.coordinates(bin).cast<double>() + 0.5).matrix().cwiseProduct(bin_size);
            const auto at = static_cast<std::size_t>(bin);
            const auto end = static_cast<std::size_t>(grid.bin_begin[at + 1]);
            for (auto to = static_cast<std::size_t>(grid.bin_begin[at]); to < end; ++to) {
                const auto from = static_cast<std::size_t>(grid.begin + order_[to]);
                const Sphere& sphere = particles.spheres[from];
                sorted.spheres[to] = sphere;
                sorted.motions[to] = particles.motions[from];
                sorted.ids[to] = particles.ids[from];
                const Vec3 offset = cell_.cartesian(sphere.center - center);
                local_.x[to] = static_cast<float>(offset[0]);
                local_.y[to] = static_cast<float>(offset[1]);
                local_.z[to] = static_cast<float>(offset[2]);
                local_.reach[to] = reach_in_single_precision(reach_, sphere.diameter, extent);
            }
        }
    });
}

}  // namespace jam
