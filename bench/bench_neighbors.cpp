// SPDX-License-Identifier: BSD-3-Clause
// Cost of building a neighbor list, sorting included, against the size ratio and the number of
// collections (Monti et al., Figs. 10 and 11).
#include "core/state_hash.h"
#include "dense_packing.h"
#include "neighbors/find_neighbors.h"

#include <benchmark/benchmark.h>

#include <map>
#include <tuple>

namespace jam::bench {
namespace {

const JamState& packing_of(double size_ratio, double alpha, Count count) {
    static std::map<std::tuple<double, double, Count>, JamState> made;
    const auto key = std::tuple(size_ratio, alpha, count);
    const auto found = made.find(key);
    if (found != made.end()) return found->second;
    return made.emplace(key, dense_packing({size_ratio, alpha, count})).first->second;
}

void build(benchmark::State& run, const JamState& packing, const SizeCollections& collections,
           int threads) {
    run_with_threads(threads, [&] {
        Particles particles = packing.particles;
        GridHierarchy hierarchy(collections);
        hierarchy.group(particles);
        NeighborScratch scratch;
        NeighborList list;
        const auto search = [&] {
            find_candidates(hierarchy, packing.cell, {0.0, 0.05}, particles, scratch, list);
        };
        search();  // sorts: what is measured is the build of a run that has begun
        for ([[maybe_unused]] auto step : run) search();
        const auto count = static_cast<double>(particles.size());
        run.counters["ns/particle"] =
            benchmark::Counter(count * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                                 benchmark::Counter::kInvert);
        run.counters["pairs"] = static_cast<double>(list.pair_count()) / count;
        run.counters["collections"] = collections.count();
        run.counters["hash"] = static_cast<double>(state_hash<Neighbor>(list.neighbors) >> 40);
    });
}

/// Arguments: size ratio, 10 alpha, particles, threads.
void size_ratio(benchmark::State& run) {
    const JamState& packing =
        packing_of(double(run.range(0)), 0.1 * double(run.range(1)), run.range(2));
    build(run, packing, geometric_collections(diameters_by_id(packing.particles)),
          static_cast<int>(run.range(3)));
}
BENCHMARK(size_ratio)
    ->ArgNames({"lambda", "alpha10", "n", "threads"})
    ->ArgsProduct({{1, 5, 10, 20, 50}, {10}, {100000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Arguments: size ratio, 100 times the ratio within a collection.
void geometric_ratio(benchmark::State& run) {
    const JamState& packing = packing_of(double(run.range(0)), 1.0, 100000);
    build(run, packing,
          geometric_collections(diameters_by_id(packing.particles),
                                {.ratio = 0.01 * double(run.range(1))}),
          1);
}
BENCHMARK(geometric_ratio)
    ->ArgNames({"lambda", "ratio100"})
    ->ArgsProduct({{10, 20, 50}, {150, 200, 300, 400, 600, 800, 100000}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Arguments: size ratio, number of equal intervals of diameter.
void linear_intervals(benchmark::State& run) {
    const JamState& packing = packing_of(double(run.range(0)), 1.0, 100000);
    build(run, packing,
          linear_collections(diameters_by_id(packing.particles), static_cast<int>(run.range(1))),
          1);
}
BENCHMARK(linear_intervals)
    ->ArgNames({"lambda", "intervals"})
    ->ArgsProduct({{10, 20, 50}, {1, 2, 4, 10, 20}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace jam::bench

BENCHMARK_MAIN();
