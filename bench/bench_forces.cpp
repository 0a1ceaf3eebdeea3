// SPDX-License-Identifier: BSD-3-Clause
// Four deterministic ways to sum contact forces, side by side on one packing: the library's tiles,
// colored cells, stored pair forces that are gathered, and a full list. With what each has to
// prepare whenever the list of near pairs is new, and a hash of the loads.
#include "core/state_hash.h"
#include "dense_packing.h"
#include "force_schemes.h"
#include "grids/collection_choice.h"
#include "neighbors/find_neighbors.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <optional>

namespace jam::bench {
namespace {

struct Options {
    std::vector<double> size_ratios = {1, 10, 20};
    Count count = 100000;
    int replicas = 1;
    std::vector<int> threads = {1, 2};
    double skin = 0.002;
    int rounds = 15;
};

double seconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A scheme under measurement: what it does for a new list, and at every evaluation.
struct Scheme {
    std::string name;
    std::function<void()> prepare;
    std::function<void()> evaluate;
    double prepare_seconds = 1e9;
    double evaluate_seconds = 1e9;
    std::uint64_t hash = 0;
};

/// All schemes in turn, again and again, so that a disturbance meets them all; the least counts.
void measure(std::vector<Scheme>& schemes, int rounds, std::vector<Load>& loads) {
    for (int round = 0; round < rounds; ++round) {
        for (Scheme& scheme : schemes) {
            if (round < 3)
                scheme.prepare_seconds = std::min(scheme.prepare_seconds, seconds(scheme.prepare));
            scheme.evaluate_seconds = std::min(scheme.evaluate_seconds, seconds(scheme.evaluate));
            scheme.hash = state_hash<Load>(loads);
        }
    }
}

void compare(const JamState& packing, double size_ratio, int threads, const Options& options) {
    Particles particles = packing.particles;
    GridHierarchy hierarchy(cheapest_collections(diameters_by_id(particles), {0.0, 0.05}));
    hierarchy.group(particles);
    NeighborScratch neighbor_scratch;
    NeighborList candidates;
    find_candidates(hierarchy, packing.cell, {0.0, 0.05}, particles, neighbor_scratch, candidates);
    const InteractionReach reach{0.0, options.skin};
    const NeighborList pairs = within_reach(candidates, packing.cell, reach, particles);
    const PairSystem system{packing.cell, particles, pairs, Material{}};
    std::vector<Load> loads(particles.spheres.size(), Load{Vec3::Zero(), 0.0});

    TileScratch tile_scratch;
    ContactTiles tiles;
    ForceScratch force_scratch;
    std::optional<ColoredCells> colored;
    std::optional<StoredPairForces> stored;
    std::optional<FullList> full;
    std::vector<Scheme> schemes;
    schemes.push_back(
        {"tiles",
         [&] { make_contact_tiles(pairs, packing.cell, reach, particles, tile_scratch, tiles); },
         [&] {
             contact_forces(packing.cell, system.material, {.damped = true}, tiles, particles,
                            loads, force_scratch);
             add_halo_loads(tiles, force_scratch.slots, loads);
         }});
    schemes.push_back(
        {"colored", [&] { colored.emplace(system); }, [&] { colored->forces(system, loads); }});
    schemes.push_back(
        {"stored", [&] { stored.emplace(system); }, [&] { stored->forces(system, loads); }});
    schemes.push_back(
        {"full list", [&] { full.emplace(system); }, [&] { full->forces(system, loads); }});
    measure(schemes, options.rounds, loads);

    const double count = particles.size();
    for (const Scheme& scheme : schemes)
        fmt::print(
            "{:>6} {:>8} {:>7} {:>6.2f}  {:10} {:>7.1f} {:>8.1f}  {:016x}{}\n", size_ratio,
            particles.size(), threads, static_cast<double>(pairs.pair_count()) / count, scheme.name,
            1e9 * scheme.evaluate_seconds / count, 1e9 * scheme.prepare_seconds / count,
            scheme.hash,
            scheme.name == "colored" ? fmt::format("  {} colors", colored->color_count()) : "");
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app{"Deterministic ways to sum contact forces, ns a particle."};
    app.add_option("--lambda", options.size_ratios, "size ratios")->delimiter(',');
    app.add_option("--n", options.count, "particles of the compressed packing");
    app.add_option("--replicas", options.replicas, "copies of it along each edge");
    app.add_option("--threads", options.threads, "one table for each")->delimiter(',');
    app.add_option("--skin", options.skin, "of the near pairs");
    app.add_option("--rounds", options.rounds, "the least of so many counts");
    CLI11_PARSE(app, argc, argv);
    fmt::print("lambda        n threads  pairs  scheme       force  prepare  hash of the loads\n");
    for (const double size_ratio : options.size_ratios) {
        DensePacking wanted;
        wanted.size_ratio = size_ratio;
        wanted.count = options.count;
        wanted.replicas = options.replicas;
        const JamState packing = dense_packing(wanted);
        for (const int threads : options.threads)
            run_with_threads(threads, [&] { compare(packing, size_ratio, threads, options); });
    }
    return 0;
}

}  // namespace
}  // namespace jam::bench

int main(int argc, char** argv) {
    try {
        return jam::bench::run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
