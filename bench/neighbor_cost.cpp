// SPDX-License-Identifier: BSD-3-Clause
#include "neighbor_cost.h"

#include "contacts/contact_forces.h"
#include "dense_packing.h"
#include "grids/collection_choice.h"
#include "neighbors/verlet_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

namespace jam::bench {

namespace {

constexpr InteractionReach list_reach{0.0, 0.05};
constexpr InteractionReach tile_reach{0.0, 0.005};

/// Of the processor, not of the wall: a busy machine lengthens it little.
double seconds(const std::function<void()>& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// The least of seven, or of as many as half a second allows, after one that touches all memory.
double least_seconds(const std::function<void()>& work) {
    work();
    double least = seconds(work);
    double spent = least;
    for (int repeat = 0; repeat < 6 && spent < 0.5; ++repeat) {
        const double now = seconds(work);
        spent += now;
        least = std::min(least, now);
    }
    return least;
}

double force_seconds(const JamState& packing, const Particles& particles,
                     const NeighborList& candidates) {
    TileScratch tile_scratch;
    ContactTiles tiles;
    make_contact_tiles(candidates, packing.cell, tile_reach, particles, tile_scratch, tiles);
    ForceScratch scratch;
    std::vector<Load> loads(particles.spheres.size(), Load{Vec3::Zero(), 0.0});
    return least_seconds([&] {
        contact_forces(packing.cell, Material{}, {.damped = true}, tiles, particles, loads,
                       scratch);
        add_halo_loads(tiles, scratch.slots, loads);
    });
}

std::string_view name_of(NeighborMethod method) {
    const auto at = std::ranges::find(neighbor_methods, method, &NamedNeighborMethod::method);
    return at->name;
}

JamState binary_packing(double size_ratio) {
    if (size_ratio > 20.0) return dense_matrix(size_ratio, size_ratio < 100.0 ? 2 : 1);
    DensePacking wanted;
    wanted.size_ratio = size_ratio;
    wanted.small_fraction = 0.5;
    wanted.replicas = 2;
    return dense_packing(wanted);
}

double expected_seconds(const std::vector<NeighborCost>& measured, NeighborMethod method,
                        double size_ratio, Count particles) {
    if (measured.empty() || measured.back().method != name_of(method)) return 0.0;
    const NeighborCost& last = measured.back();
    const double growth =
        method == NeighborMethod::multi ? 1.0 : std::pow(size_ratio / last.size_ratio, 3);
    return 1e-9 * last.build_ns * growth * static_cast<double>(particles);
}

void tell(const NeighborCost& cost) {
    fmt::print(stderr,
               "{:10} lambda {:<5} alpha {:<4} N {:<9} {:2} {:10} build {:9.1f}  force {:6.1f}  "
               "ratio {:7.1f}  model {:6.0f}\n",
               cost.method, cost.size_ratio, cost.alpha, cost.particles, cost.collections,
               cost.spacing, cost.build_ns, cost.force_ns, cost.build_ns / cost.force_ns,
               cost.model_ns);
}

}  // namespace

NeighborCost measure_neighbor_cost(NeighborMethod method, const SizeCollections& collections,
                                   const JamState& packing) {
    Particles particles = packing.particles;
    GridHierarchy hierarchy(collections_for(method, collections));
    hierarchy.group(particles);
    NeighborScratch scratch;
    NeighborList list;
    const auto build = [&] {
        find_candidates(hierarchy, packing.cell, list_reach, particles, scratch, list, method);
    };
    // The first build sorts; it counts only where a second one would take too long.
    double build_seconds = seconds(build);
    if (build_seconds < 60.0) build_seconds = least_seconds(build);
    const auto count = static_cast<double>(particles.size());
    NeighborCost cost;
    cost.method = name_of(method);
    cost.particles = particles.size();
    cost.collections = hierarchy.collections().count();
    cost.build_ns = 1e9 * build_seconds / count;
    scratch = {};
    cost.force_ns = 1e9 * force_seconds(packing, particles, list) / count;
    return cost;
}

std::vector<NeighborCost> sweep_methods(const std::vector<NeighborMethod>& methods,
                                        const std::vector<double>& size_ratios,
                                        double most_seconds) {
    std::vector<NeighborCost> costs;
    for (const NeighborMethod method : methods) {
        for (const double size_ratio : size_ratios) {
            const JamState packing = binary_packing(size_ratio);
            if (expected_seconds(costs, method, size_ratio, packing.particles.size()) >
                most_seconds)
                break;
            const SizeCollections collections =
                cheapest_collections(diameters_by_id(packing.particles), list_reach);
            NeighborCost& cost =
                costs.emplace_back(measure_neighbor_cost(method, collections, packing));
            cost.size_ratio = size_ratio;
            cost.spacing = "automatic";
            tell(cost);
        }
    }
    return costs;
}

std::vector<NeighborCost> sweep_collections(const std::vector<double>& size_ratios,
                                            const std::vector<double>& alphas) {
    std::vector<NeighborCost> costs;
    for (const double alpha : alphas) {
        for (const double size_ratio : size_ratios) {
            DensePacking wanted;
            wanted.size_ratio = size_ratio;
            wanted.alpha = alpha;
            wanted.count = size_ratio > 50.0 ? 50000 : 100000;
            const JamState packing = dense_packing(wanted);
            const std::vector<double> diameters = diameters_by_id(packing.particles);
            const auto add = [&](const std::string& spacing, const SizeCollections& collections) {
                NeighborCost& cost = costs.emplace_back(
                    measure_neighbor_cost(NeighborMethod::multi, collections, packing));
                cost.size_ratio = size_ratio;
                cost.alpha = alpha;
                cost.spacing = spacing;
                cost.model_ns = search_cost(diameters, collections, list_reach);
                tell(cost);
            };
            add("automatic", cheapest_collections(diameters, list_reach));
            for (const int count : {1, 2, 3, 4, 5, 6, 8, 10}) {
                if (count == 1 && size_ratio > 20.0) continue;  // minutes, and far from the best
                add("geometric",
                    geometric_collections(diameters, {.ratio = std::pow(size_ratio, 1.0 / count)}));
            }
            for (const int count : {2, 3, 4, 6, 10, 20})
                add("linear", linear_collections(diameters, count));
        }
    }
    return costs;
}

}  // namespace jam::bench
