// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/find_neighbors.h"

#include "core/parallel.h"
#include "neighbors/candidate_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace jam {

namespace {

using Words = std::vector<std::uint32_t>;

/// Whole-number division and remainder that round down: bin of an unwrapped coordinate, and its
/// image.
struct WrappedBin {
    int bin;
    int image;
};
WrappedBin wrap_bin(int unwrapped, int bins) {
    int image = unwrapped / bins;
    if (unwrapped - image * bins < 0) --image;
    return {unwrapped - image * bins, image};
}

/// One bin that searches: where it is and what encloses its members' reach.
struct SearchingBin {
    Eigen::Array3i at;
    Index begin, end;
    Vec3 center;         ///< fractional
    LocalSphere bounds;  ///< about every member with its reach
};

LocalSphere bounds_of_members(const LocalSpheres& local, Index begin, Index end) {
    const auto first = static_cast<std::size_t>(begin);
    const auto last = static_cast<std::size_t>(end);
    float low[3] = {local.x[first], local.y[first], local.z[first]};
    float high[3] = {low[0], low[1], low[2]};
    for (std::size_t i = first; i < last; ++i) {
        low[0] = std::min(low[0], local.x[i]);
        high[0] = std::max(high[0], local.x[i]);
        low[1] = std::min(low[1], local.y[i]);
        high[1] = std::max(high[1], local.y[i]);
        low[2] = std::min(low[2], local.z[i]);
        high[2] = std::max(high[2], local.z[i]);
    }
    LocalSphere bounds{0.5f * (low[0] + high[0]), 0.5f * (low[1] + high[1]),
                       0.5f * (low[2] + high[2]), 0.0f};
    for (std::size_t i = first; i < last; ++i) {
        const float dx = local.x[i] - bounds.x;
        const float dy = local.y[i] - bounds.y;
        const float dz = local.z[i] - bounds.z;
        const float farthest = std::sqrt(dx * dx + dy * dy + dz * dz) * (1.0f + 0x1p-20f);
        bounds.reach = std::max(bounds.reach, farthest + local.reach[i]);
    }
    return bounds;
}

/// The search of one collection's bins in its own grid and in all larger ones.
class CollectionSearch {
  public:
    CollectionSearch(const GridHierarchy& hierarchy, std::size_t collection)
        : hierarchy_(hierarchy), own_(collection) {}

    /// Lists the neighbors of the members of bins [first, last) into `found`, row after row, and
    /// each row's length into `row_length`.
    void search(Index first_bin, Index last_bin, CandidateBuffer& buffer, Words& found,
                std::vector<Index>& row_length) const {
        found.clear();
        const CollectionGrid& grid = hierarchy_.grids()[own_];
        for (Index bin = first_bin; bin < last_bin; ++bin) {
            const SearchingBin searching = searching_bin(grid, bin);
            if (searching.begin == searching.end) continue;
            gather(searching, buffer);
            test_members(searching, buffer, found, row_length);
        }
    }

  private:
    SearchingBin searching_bin(const CollectionGrid& grid, Index bin) const {
        SearchingBin searching;
        searching.at = grid.coordinates(bin);
        searching.begin = grid.bin_begin[static_cast<std::size_t>(bin)];
        searching.end = grid.bin_begin[static_cast<std::size_t>(bin) + 1];
        searching.center =
            ((searching.at.cast<double>() + 0.5) / grid.bins.cast<double>()).matrix();
        if (searching.begin != searching.end)
            searching.bounds =
                bounds_of_members(hierarchy_.local(), searching.begin, searching.end);
        return searching;
    }

    /// The bin's own members come first, so that member k tests only what stands behind it.
    void gather(const SearchingBin& searching, CandidateBuffer& buffer) const {
        buffer.clear();
        buffer.append_all(hierarchy_.local(), searching.begin, searching.end);
        for (std::size_t c = own_; c < hierarchy_.grids().size(); ++c)
            gather_from(hierarchy_.grids()[c], c == own_, searching, buffer);
        buffer.pad();
    }

    /// Bins of `grid` that the bounds touch. Of its own grid a bin searches only those that follow
    /// it in (z, y, x), unwrapped: every pair of bins, images told apart, is searched from one
    /// side.
    void gather_from(const CollectionGrid& grid, bool own, const SearchingBin& searching,
                     CandidateBuffer& buffer) const {
        const PeriodicCell& cell = hierarchy_.cell();
        const Vec3 middle =
            searching.center +
            cell.fractional({searching.bounds.x, searching.bounds.y, searching.bounds.z});
        const Vec3 reach = Vec3::Constant(searching.bounds.reach + grid.largest_reach)
                               .cwiseQuotient(cell.perpendicular_widths());
        const Eigen::Array3d bins = grid.bins.cast<double>();
        const Eigen::Array3i low = ((middle - reach).array() * bins).floor().cast<int>();
        const Eigen::Array3i high = ((middle + reach).array() * bins).floor().cast<int>();
        const Eigen::Array3i& at = searching.at;
        for (int z = own ? std::max(low[2], at[2]) : low[2]; z <= high[2]; ++z) {
            const bool same_z = own && z == at[2];
            for (int y = same_z ? std::max(low[1], at[1]) : low[1]; y <= high[1]; ++y) {
                const bool same_row = same_z && y == at[1];
                for (int x = same_row ? std::max(low[0], at[0] + 1) : low[0]; x <= high[0]; ++x)
                    gather_bin(grid, {x, y, z}, searching, buffer);
            }
        }
    }

    void gather_bin(const CollectionGrid& grid, const Eigen::Array3i& unwrapped,
                    const SearchingBin& searching, CandidateBuffer& buffer) const {
        const WrappedBin x = wrap_bin(unwrapped[0], grid.bins[0]);
        const WrappedBin y = wrap_bin(unwrapped[1], grid.bins[1]);
        const WrappedBin z = wrap_bin(unwrapped[2], grid.bins[2]);
        // Centers farther off than one image are farther apart than the cell is wide.
        if (std::abs(x.image) > 1 || std::abs(y.image) > 1 || std::abs(z.image) > 1) return;
        const auto bin = static_cast<std::size_t>(grid.bin_at(x.bin, y.bin, z.bin));
        const Index begin = grid.bin_begin[bin];
        const Index end = grid.bin_begin[bin + 1];
        if (begin == end) return;
        const Vec3 center = ((unwrapped.cast<double>() + 0.5) / grid.bins.cast<double>()).matrix();
        const Vec3 offset = hierarchy_.cell().cartesian(center - searching.center);
        const LocalSphere moved{static_cast<float>(offset[0]), static_cast<float>(offset[1]),
                                static_cast<float>(offset[2]), 0.0f};
        // The listed image is added to the neighbor; see Neighbor for the sign.
        buffer.append_near(hierarchy_.local(), begin, end, moved, searching.bounds,
                           image_code(x.image, y.image, z.image));
    }

    void test_members(const SearchingBin& searching, const CandidateBuffer& buffer, Words& found,
                      std::vector<Index>& row_length) const {
        const int members = searching.end - searching.begin;
        for (int member = 0; member < members; ++member) {
            const std::size_t before = found.size();
            test_member(member, buffer, found);
            row_length[static_cast<std::size_t>(searching.begin + member)] =
                static_cast<Index>(found.size() - before);
        }
    }

    static void test_member(int member, const CandidateBuffer& buffer, Words& found) {
        const LocalSphere sphere = buffer.sphere(member);
        const int first = (member + 1) & ~(lane_count - 1);
        std::uint32_t behind = ~0u << (member + 1 - first);
        for (int at = first; at < buffer.size(); at += lane_count, behind = ~0u) {
            std::uint32_t near = buffer.near(at, sphere) & behind;
            for (; near != 0; near &= near - 1)
                found.push_back(buffer.word(at + std::countr_zero(near)));
        }
    }

    const GridHierarchy& hierarchy_;
    std::size_t own_;
};

/// Bins that make one task, by count alone: about a thousand particles.
Count bins_per_task(const CollectionGrid& grid) {
    const Count particles_per_task = 1024;
    return std::max<Count>(1, particles_per_task * grid.bin_count() / grid.member_count());
}

void search_collection(const GridHierarchy& hierarchy, std::size_t collection,
                       NeighborScratch& scratch, PerThread<CandidateBuffer>& buffers) {
    const CollectionGrid& grid = hierarchy.grids()[collection];
    auto& found = scratch.found[collection];
    const Count bins = bins_per_task(grid);
    found.resize(static_cast<std::size_t>(block_count(grid.bin_count(), bins)));
    const CollectionSearch search(hierarchy, collection);
    for_each_block(grid.bin_count(), bins, [&](Count block, Count first, Count last) {
        search.search(static_cast<Index>(first), static_cast<Index>(last), buffers.local(),
                      found[static_cast<std::size_t>(block)], scratch.row_length);
    });
}

/// Rows of all blocks, one after the other: count, scan, fill.
void assemble(const GridHierarchy& hierarchy, const NeighborScratch& scratch, NeighborList& list) {
    const std::size_t count = scratch.row_length.size();
    list.row_begin.resize(count + 1);
    Count before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        list.row_begin[i] = before;
        before += scratch.row_length[i];
    }
    list.row_begin[count] = before;
    list.neighbors.resize(static_cast<std::size_t>(before));
    for (std::size_t c = 0; c < scratch.found.size(); ++c) {
        const CollectionGrid& grid = hierarchy.grids()[c];
        const Count bins = bins_per_task(grid);
        for_each_block(grid.bin_count(), bins, [&](Count block, Count first, Count) {
            const auto row =
                static_cast<std::size_t>(grid.bin_begin[static_cast<std::size_t>(first)]);
            const Words& words = scratch.found[c][static_cast<std::size_t>(block)];
            std::transform(words.begin(), words.end(), list.neighbors.begin() + list.row_begin[row],
                           &Neighbor::from_word);
        });
    }
}

}  // namespace

void find_candidates(GridHierarchy& hierarchy, const PeriodicCell& cell,
                     const InteractionReach& reach, Particles& particles, NeighborScratch& scratch,
                     NeighborList& candidates) {
    const std::size_t collections = hierarchy.grids().size();
    scratch.found.resize(collections);
    scratch.row_length.resize(particles.spheres.size());
    PerThread<CandidateBuffer> buffers;

    TaskGraph graph;
    const auto sorting = hierarchy.add_sorting(graph, cell, reach, particles, scratch.sorted);
    for (std::size_t c = 0; c < collections; ++c)
        graph.add([&, c] { search_collection(hierarchy, c, scratch, buffers); },
                  {sorting.begin() + static_cast<std::ptrdiff_t>(c), sorting.end()});
    graph.run();
    std::swap(particles, scratch.sorted);
    assemble(hierarchy, scratch, candidates);
}

NeighborList within_reach(const NeighborList& candidates, const PeriodicCell& cell,
                          const InteractionReach& reach, const Particles& particles) {
    NeighborList list;
    list.row_begin.push_back(0);
    for (Index i = 0; i < candidates.particle_count(); ++i) {
        const Sphere& sphere = particles.spheres[static_cast<std::size_t>(i)];
        for (const Neighbor neighbor : candidates.row(i)) {
            const Sphere& other = particles.spheres[static_cast<std::size_t>(neighbor.particle())];
            const ImageShift& shift = image_shifts[neighbor.image()];
            const Vec3 apart =
                cell.cartesian(sphere.center - other.center - Vec3(shift.x, shift.y, shift.z));
            const double farthest = reach.of(sphere.diameter, other.diameter);
            if (apart.squaredNorm() <= farthest * farthest) list.neighbors.push_back(neighbor);
        }
        list.row_begin.push_back(static_cast<Count>(list.neighbors.size()));
    }
    return list;
}

}  // namespace jam
