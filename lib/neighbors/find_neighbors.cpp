// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/find_neighbors.h"

#include "core/parallel.h"
#include "neighbors/candidate_buffer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace jam {

namespace {

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
    void search(Index first_bin, Index last_bin, CandidateBuffer& buffer, FoundWords& found,
                std::vector<Index>& row_length) const {
        found.count = 0;
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
                gather_row(grid, same_row ? std::max(low[0], at[0] + 1) : low[0], high[0], y, z,
                           searching, buffer);
            }
        }
    }

    /// Bins low..high of one row of a grid, all unwrapped. A search spends a good part of its time
    /// on going from bin to bin, so all but one coordinate of the way there is found once a row.
    void gather_row(const CollectionGrid& grid, int low, int high, int y, int z,
                    const SearchingBin& searching, CandidateBuffer& buffer) const {
        const WrappedBin row_y = wrap_bin(y, grid.bins[1]);
        const WrappedBin row_z = wrap_bin(z, grid.bins[2]);
        if (is_beyond_one_image(row_y) || is_beyond_one_image(row_z)) return;
        const Vec3 step = (1.0 / grid.bins.cast<double>()).matrix();
        const Vec3 begin = Vec3(low + 0.5, y + 0.5, z + 0.5).cwiseProduct(step) - searching.center;
        const Vec3 offset = hierarchy_.cell().cartesian(begin);
        const double step_x = hierarchy_.cell().matrix()(0, 0) * step[0];
        for (int x = low; x <= high; ++x) {
            const WrappedBin wrapped = wrap_bin(x, grid.bins[0]);
            if (is_beyond_one_image(wrapped)) continue;
            const auto bin =
                static_cast<std::size_t>(grid.bin_at(wrapped.bin, row_y.bin, row_z.bin));
            const Index first = grid.bin_begin[bin];
            const Index last = grid.bin_begin[bin + 1];
            if (first == last) continue;
            const LocalSphere moved{static_cast<float>(offset[0] + (x - low) * step_x),
                                    static_cast<float>(offset[1]), static_cast<float>(offset[2]),
                                    0.0f};
            buffer.append_near(hierarchy_.local(), first, last, moved, searching.bounds,
                               image_code(wrapped.image, row_y.image, row_z.image));
        }
    }

    /// Centers farther off than one image are farther apart than the cell is wide.
    static bool is_beyond_one_image(const WrappedBin& wrapped) {
        return wrapped.image < -1 || wrapped.image > 1;
    }

    void test_members(const SearchingBin& searching, const CandidateBuffer& buffer,
                      FoundWords& found, std::vector<Index>& row_length) const {
        const int members = searching.end - searching.begin;
        for (int member = 0; member < members; ++member) {
            const std::size_t before = found.count;
            found.reserve(static_cast<std::size_t>(buffer.size()) + lane_count);
            found.count += buffer.copy_near(member, found.words.data() + before);
            row_length[static_cast<std::size_t>(searching.begin + member)] =
                static_cast<Index>(found.count - before);
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

/// Makes room for rows of the given lengths.
void place_rows(const std::vector<Index>& row_length, NeighborList& list) {
    constexpr Count rows_per_block = 1 << 14;
    const auto count = static_cast<Count>(row_length.size());
    const auto sum = [&](Count begin, Count end) {
        return std::accumulate(row_length.begin() + begin, row_length.begin() + end, Count{0});
    };
    std::vector<Count> before(static_cast<std::size_t>(block_count(count, rows_per_block)));
    for_each_block(count, rows_per_block, [&](Count block, Count begin, Count end) {
        before[static_cast<std::size_t>(block)] = sum(begin, end);
    });
    const Count pairs = exclusive_scan(before);
    list.row_begin.resize(row_length.size() + 1);
    for_each_block(count, rows_per_block, [&](Count block, Count begin, Count end) {
        Count next = before[static_cast<std::size_t>(block)];
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            list.row_begin[i] = next;
            next += row_length[i];
        }
    });
    list.row_begin.back() = pairs;
    list.neighbors.resize(static_cast<std::size_t>(pairs));
}

void fill_rows(Index first_row, std::span<const std::uint32_t> words, NeighborList& list) {
    std::transform(words.begin(), words.end(),
                   list.neighbors.begin() + list.row_begin[static_cast<std::size_t>(first_row)],
                   &Neighbor::from_word);
}

/// Rows of all blocks, one after the other: count, scan, fill.
void assemble(const GridHierarchy& hierarchy, const NeighborScratch& scratch, NeighborList& list) {
    place_rows(scratch.row_length, list);
    for (std::size_t c = 0; c < scratch.found.size(); ++c) {
        const CollectionGrid& grid = hierarchy.grids()[c];
        const Count bins = bins_per_task(grid);
        for_each_block(grid.bin_count(), bins, [&](Count block, Count first, Count) {
            fill_rows(grid.bin_begin[static_cast<std::size_t>(first)],
                      scratch.found[c][static_cast<std::size_t>(block)].span(), list);
        });
    }
}

/// Sorting of the collections and their searches, as one graph.
void find_over_hierarchy(GridHierarchy& hierarchy, const PeriodicCell& cell,
                         const InteractionReach& reach, Particles& particles,
                         NeighborScratch& scratch, NeighborList& candidates) {
    const std::size_t collections = hierarchy.grids().size();
    scratch.found.resize(collections);
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

void find_over_fine_grid(GridHierarchy& hierarchy, const PeriodicCell& cell,
                         const InteractionReach& reach, Particles& particles,
                         NeighborScratch& scratch, NeighborList& candidates) {
    TaskGraph graph;
    hierarchy.add_sorting(graph, cell, reach, particles, scratch.sorted);
    graph.run();
    std::swap(particles, scratch.sorted);
    search_fine_grid(hierarchy, particles, scratch.fine_grid, scratch.row_length);
    place_rows(scratch.row_length, candidates);
    const auto& found = scratch.fine_grid.found;
    for_each_task(static_cast<Count>(found.size()), [&](Count block) {
        fill_rows(static_cast<Index>(block * fine_grid_block),
                  found[static_cast<std::size_t>(block)], candidates);
    });
}

}  // namespace

SizeCollections collections_for(NeighborMethod method, const SizeCollections& chosen) {
    if (method != NeighborMethod::one_grid) return chosen;
    return {.upper = {chosen.upper.back()}, .begin = {0, chosen.begin.back()}};
}

void find_candidates(GridHierarchy& hierarchy, const PeriodicCell& cell,
                     const InteractionReach& reach, Particles& particles, NeighborScratch& scratch,
                     NeighborList& candidates, NeighborMethod method) {
    scratch.row_length.resize(particles.spheres.size());
    const auto find =
        method == NeighborMethod::multi_old ? find_over_fine_grid : find_over_hierarchy;
    find(hierarchy, cell, reach, particles, scratch, candidates);
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
