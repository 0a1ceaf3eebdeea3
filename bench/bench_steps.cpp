// SPDX-License-Identifier: BSD-3-Clause
// Cost of a list build, a force evaluation and a whole step at constant pressure, against the
// number of particles, the size ratio, the skin and the threads, with a hash of the result beside
// every time: the same for any number of threads.
#include "core/state_hash.h"
#include "dense_packing.h"
#include "jamming/nph_step.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace jam::bench {
namespace {

/// Up to half a million particles are compressed; more are copies of so many.
DensePacking packing_of(double size_ratio, Count count) {
    DensePacking wanted{size_ratio, 1.0, count};
    while (wanted.count > 500'000) {
        ++wanted.replicas;
        wanted.count = count / (wanted.replicas * wanted.replicas * wanted.replicas);
    }
    return wanted;
}

void report(benchmark::State& run, const JamState& state) {
    run.counters["ns/particle"] = benchmark::Counter(
        static_cast<double>(state.particles.size()) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    std::uint64_t hash = state_hash<Sphere>(state.particles.spheres);
    hash = state_hash<Load>(state.particles.loads, hash);
    run.counters["hash"] = static_cast<double>(hash >> 32);
}

ListSettings with_outer_skin(double skin) {
    ListSettings settings;
    settings.outer_skin = skin;
    settings.widest_outer_skin = skin;
    return settings;
}

/// A run that has begun, with lists of the given outer skin.
struct Begun {
    Begun(const DensePacking& wanted, double skin)
        : state(dense_packing(wanted)),
          settings(nph_settings(bench_scene(wanted), state)),
          scratch(diameters_by_id(state.particles), with_outer_skin(skin)) {
        begin_nph(state, settings, scratch);
    }
    void step(int count) {
        for (int done = 0; done < count; ++done) nph_step(state, settings, scratch);
    }

    JamState state;
    NphSettings settings;
    NphScratch scratch;
};

/// Arguments: size ratio, particles, 1000 times the outer skin, threads. Lists are renewed as the
/// motion asks for it, and are in the time.
void whole_step(benchmark::State& run) {
    const DensePacking wanted = packing_of(double(run.range(0)), run.range(1));
    run_with_threads(static_cast<int>(run.range(3)), [&] {
        Begun begun(wanted, 1e-3 * double(run.range(2)));
        begun.step(50);
        const Count searches = begun.scratch.lists.searches;
        for ([[maybe_unused]] auto step : run) begun.step(1);
        run.counters["searches"] = static_cast<double>(begun.scratch.lists.searches - searches);
        run.counters["Z"] =
            2.0 * static_cast<double>(begun.scratch.sums.contacts) / begun.state.particles.size();
        report(run, begun.state);
    });
}

/// Arguments: size ratio, particles, 1000 times the outer skin, threads.
void list_build(benchmark::State& run) {
    const DensePacking wanted = packing_of(double(run.range(0)), run.range(1));
    run_with_threads(static_cast<int>(run.range(3)), [&] {
        Begun begun(wanted, 1e-3 * double(run.range(2)));
        VerletLists& lists = begun.scratch.lists;
        for ([[maybe_unused]] auto step : run)
            find_candidates(lists.hierarchy, begun.state.cell, lists.outer.reach,
                            begun.state.particles, lists.neighbor_scratch, lists.candidates);
        run.counters["pairs"] =
            static_cast<double>(lists.candidates.pair_count()) / begun.state.particles.size();
        report(run, begun.state);
    });
}

/// Arguments: as list_build. Over the tiles that a run has there.
void forces(benchmark::State& run) {
    const DensePacking wanted = packing_of(double(run.range(0)), run.range(1));
    run_with_threads(static_cast<int>(run.range(3)), [&] {
        Begun begun(wanted, 1e-3 * double(run.range(2)));
        begun.step(20);
        JamState& state = begun.state;
        for ([[maybe_unused]] auto step : run) {
            contact_forces(state.cell, begun.settings.material, {.damped = true},
                           begun.scratch.lists.tiles, state.particles, state.particles.loads,
                           begun.scratch.forces);
            add_halo_loads(begun.scratch.lists.tiles, begun.scratch.forces.slots,
                           state.particles.loads);
        }
        run.counters["pairs"] =
            static_cast<double>(begun.scratch.lists.tiles.pair_count()) / state.particles.size();
        report(run, state);
    });
}

/// Against N, lambda and threads at the usual skin; and against the skin at one N.
void arguments(benchmark::internal::Benchmark* benchmark, const std::vector<std::int64_t>& counts) {
    benchmark->ArgNames({"lambda", "n", "skin1000", "threads"})
        ->ArgsProduct({{1, 10, 20}, counts, {100}, {1, 2}})
        ->ArgsProduct({{1, 10, 20}, {100000}, {50, 200}, {1}})
        ->UseRealTime()
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMicrosecond);
}

BENCHMARK(whole_step)
    ->Apply([](auto* one) {
        arguments(one, {1000, 4000, 10000, 100000, 1000000, 4000000});
    }) -> Iterations(200);
BENCHMARK(list_build)->Apply([](auto* one) { arguments(one, {4000, 100000, 1000000}); });
BENCHMARK(forces)->Apply([](auto* one) {
    arguments(one, {1000, 4000, 10000, 100000, 1000000, 4000000});
});

}  // namespace
}  // namespace jam::bench

BENCHMARK_MAIN();
