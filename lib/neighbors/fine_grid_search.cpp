// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/fine_grid_search.h"

#include "core/parallel.h"

namespace jam {

namespace {

using Words = std::vector<std::uint32_t>;

/// The rows of some particles, one after the other.
class StencilSearch {
  public:
    StencilSearch(const GridHierarchy& hierarchy, const Particles& particles,
                  const FineGridScratch& scratch)
        : hierarchy_(hierarchy), spheres_(particles.spheres), grid_(scratch.grid), s_(scratch) {}

    /// Appends the neighbors of particle i of collection `own` in its own and all larger ones.
    void search(Index i, std::size_t own, Words& found) const {
        for (std::size_t other = own; other < hierarchy_.grids().size(); ++other)
            walk_stencil(i, own, other, found);
    }

  private:
    const Sphere& sphere(Index i) const { return spheres_[static_cast<std::size_t>(i)]; }

    void walk_stencil(Index i, std::size_t own, std::size_t other, Words& found) const {
        const double reach =
            hierarchy_.reach().of(sphere(i).diameter, hierarchy_.grids()[other].largest_diameter);
        const Vec3 extent =
            Vec3::Constant(reach).cwiseQuotient(hierarchy_.cell().perpendicular_widths());
        const Eigen::Array3d bins = grid_.bins.cast<double>();
        const Vec3& center = sphere(i).center;
        const Eigen::Array3i low = ((center - extent).array() * bins).floor().cast<int>();
        const Eigen::Array3i high = ((center + extent).array() * bins).floor().cast<int>();
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x) search_bin(i, own, other, {x, y, z}, found);
    }

    void search_bin(Index i, std::size_t own, std::size_t other, const Eigen::Array3i& unwrapped,
                    Words& found) const {
        const WrappedBin x = wrap_bin(unwrapped[0], grid_.bins[0]);
        const WrappedBin y = wrap_bin(unwrapped[1], grid_.bins[1]);
        const WrappedBin z = wrap_bin(unwrapped[2], grid_.bins[2]);
        if (std::abs(x.image) > 1 || std::abs(y.image) > 1 || std::abs(z.image) > 1) return;
        const std::uint32_t image = image_code(x.image, y.image, z.image);
        const auto bin = static_cast<std::size_t>(grid_.bin_at(x.bin, y.bin, z.bin));
        const CollectionGrid& members = hierarchy_.grids()[other];
        for (Index k = grid_.bin_begin[bin]; k < grid_.bin_begin[bin + 1]; ++k) {
            const Index j = s_.order[static_cast<std::size_t>(k)];
            if (j < members.begin || j >= members.end) continue;
            // Of a pair within one collection, seen through opposite images, one side lists it.
            if (own == other && (image < home_image || (image == home_image && j <= i))) continue;
            if (is_near(i, j, image)) found.push_back(Neighbor(j, image).word());
        }
    }

    bool is_near(Index i, Index j, std::uint32_t image) const {
        const ImageShift& shift = image_shifts[image];
        const Vec3 apart = hierarchy_.cell().cartesian(sphere(i).center - sphere(j).center -
                                                       Vec3(shift.x, shift.y, shift.z));
        const double farthest = hierarchy_.reach().of(sphere(i).diameter, sphere(j).diameter);
        return apart.squaredNorm() <= farthest * farthest;
    }

    const GridHierarchy& hierarchy_;
    const std::vector<Sphere>& spheres_;
    const CollectionGrid& grid_;
    const FineGridScratch& s_;
};

void sort_into_fine_grid(const GridHierarchy& hierarchy, const Particles& particles,
                         FineGridScratch& scratch) {
    const auto count = static_cast<std::size_t>(particles.size());
    const double width = 2.0 * hierarchy.reach().of(hierarchy.collections().upper.front());
    set_bins(scratch.grid, bins_along_edges(hierarchy.cell(), width, particles.size()));
    scratch.bin_of_particle.resize(count);
    scratch.order.resize(count);
    for_each_block(particles.size(), fine_grid_block, [&](Count, Count begin, Count end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            scratch.bin_of_particle[i] = bin_of(scratch.grid, particles.spheres[i].center);
    });
    counting_sort(scratch.bin_of_particle, scratch.grid.bin_count(), scratch.grid.bin_begin,
                  scratch.order);
}

}  // namespace

void search_fine_grid(const GridHierarchy& hierarchy, const Particles& particles,
                      FineGridScratch& scratch, std::vector<Index>& row_length) {
    sort_into_fine_grid(hierarchy, particles, scratch);
    scratch.found.resize(static_cast<std::size_t>(block_count(particles.size(), fine_grid_block)));
    const StencilSearch search(hierarchy, particles, scratch);
    for_each_block(particles.size(), fine_grid_block, [&](Count block, Count begin, Count end) {
        Words& found = scratch.found[static_cast<std::size_t>(block)];
        found.clear();
        for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
            const double diameter = particles.spheres[static_cast<std::size_t>(i)].diameter;
            const std::size_t before = found.size();
            search.search(
                i, static_cast<std::size_t>(collection_of(hierarchy.collections(), diameter)),
                found);
            row_length[static_cast<std::size_t>(i)] = static_cast<Index>(found.size() - before);
        }
    });
}

}  // namespace jam
