// SPDX-License-Identifier: BSD-3-Clause
// Cost of a force evaluation and of a whole step at constant pressure, with a hash of the state
// beside every time: the same for any number of threads.
#include "core/state_hash.h"
#include "dense_packing.h"
#include "jamming/nph_step.h"

#include <benchmark/benchmark.h>

namespace jam::bench {
namespace {

void report(benchmark::State& run, const JamState& state) {
    run.counters["ns/particle"] = benchmark::Counter(
        static_cast<double>(state.particles.size()) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    run.counters["hash"] = static_cast<double>(state_hash<Sphere>(state.particles.spheres) >> 40);
}

/// Arguments: size ratio, particles, threads. Lists are renewed as the motion asks for it, and are
/// in the time.
void whole_step(benchmark::State& run) {
    const DensePacking wanted{double(run.range(0)), 1.0, run.range(1)};
    const Scene scene = bench_scene(wanted);
    JamState state = dense_packing(wanted);
    run_with_threads(static_cast<int>(run.range(2)), [&] {
        const NphSettings settings = nph_settings(scene, state);
        NphScratch scratch(diameters_by_id(state.particles), {});
        begin_nph(state, settings, scratch);
        for (int step = 0; step < 200; ++step) nph_step(state, settings, scratch);
        for ([[maybe_unused]] auto step : run) nph_step(state, settings, scratch);
        run.counters["Z"] =
            2.0 * static_cast<double>(scratch.sums.contacts) / state.particles.size();
    });
    report(run, state);
}
BENCHMARK(whole_step)
    ->ArgNames({"lambda", "n", "threads"})
    ->ArgsProduct({{1, 10, 20}, {4000, 100000}, {1, 2}})
    ->Iterations(200)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

/// Arguments: size ratio, particles, threads.
void forces(benchmark::State& run) {
    const DensePacking wanted{double(run.range(0)), 1.0, run.range(1)};
    const Scene scene = bench_scene(wanted);
    JamState state = dense_packing(wanted);
    run_with_threads(static_cast<int>(run.range(2)), [&] {
        const NphSettings settings = nph_settings(scene, state);
        NphScratch scratch(diameters_by_id(state.particles), {});
        begin_nph(state, settings, scratch);
        for (int step = 0; step < 50; ++step) nph_step(state, settings, scratch);
        for ([[maybe_unused]] auto step : run) {
            contact_forces(state.cell, settings.material, {.damped = true}, scratch.lists.tiles,
                           state.particles, state.particles.loads, scratch.forces);
            add_halo_loads(scratch.lists.tiles, scratch.forces.slots, state.particles.loads);
        }
        run.counters["pairs"] =
            static_cast<double>(scratch.lists.tiles.pair_count()) / state.particles.size();
    });
    report(run, state);
}
BENCHMARK(forces)
    ->ArgNames({"lambda", "n", "threads"})
    ->ArgsProduct({{1, 10, 20}, {4000, 100000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace jam::bench

BENCHMARK_MAIN();
