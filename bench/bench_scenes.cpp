// SPDX-License-Identifier: BSD-3-Clause
// What a run costs as a whole, everything in: steps at constant pressure from a dense packing, by
// stage, with lists renewed as the motion asks for it; beside it one build of a list and one force
// evaluation alone, the memory, and a hash of the final state. bench/compare_lammps runs it on one
// packing beside LAMMPS.
#include "core/check.h"
#include "core/parallel.h"
#include "core/state_hash.h"
#include "dense_packing.h"
#include "grids/collection_choice.h"
#include "jamming/nph_step.h"
#include "neighbor_cost.h"
#include "packing/lammps_data.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <ctime>
#include <fstream>
#include <sys/resource.h>

namespace jam::bench {
namespace {

struct Options {
    DensePacking packing;
    int steps = 500;
    std::vector<int> threads = {1, 2};
    std::string masses = "true";
    std::string lammps_data;
    std::string json;
};

struct SceneCost {
    int threads = 1;
    double build_ns = 0.0;  ///< all a particle; stages and step a particle and step
    double force_ns = 0.0;
    double step_ns = 0.0;  ///< wall time
    double step_cpu_ns = 0.0;
    StageTimes times;
    Count searches = 0;
    Count refilters = 0;
    double coordination = 0.0;
    std::uint64_t hash = 0;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The paper's time step and, unless told otherwise, its masses: what LAMMPS is given, too.
Scene measured_scene(const Options& options) {
    Scene scene = bench_scene(options.packing);
    scene.protocol.masses = options.masses == "true" ? Masses::true_mass : Masses::diameter;
    if (options.masses == "true") scene.protocol.time_step = 0.02;
    return scene;
}

/// The same particles with the masses of `scene`, at rest.
JamState at_rest(const JamState& packing, const Scene& scene) {
    JamState state = packing;
    for (std::size_t i = 0; i < state.particles.motions.size(); ++i)
        state.particles.motions[i] = {Vec3::Zero(),
                                      inertial_mass(state.particles.spheres[i].diameter, 1.0,
                                                    scene.protocol.masses, scene.contact.density)};
    return state;
}

SceneCost measure(const Options& options, const Scene& scene, const JamState& packing,
                  int threads) {
    SceneCost cost;
    cost.threads = threads;
    JamState state = at_rest(packing, scene);
    run_with_threads(threads, [&] {
        const std::vector<double> diameters = diameters_by_id(state.particles);
        const NeighborCost lists = measure_neighbor_cost(
            NeighborMethod::multi, cheapest_collections(diameters, {0.0, 0.05}), state);
        cost.build_ns = lists.build_ns;
        cost.force_ns = lists.force_ns;
        const NphSettings settings = nph_settings(scene, state);
        NphScratch scratch(diameters, {});
        begin_nph(state, settings, scratch);
        for (int step = 0; step < options.steps / 10; ++step) nph_step(state, settings, scratch);
        scratch.times = {};
        const Count searches = scratch.lists.searches;
        const Count refilters = scratch.lists.refilters;
        const std::clock_t cpu_begin = std::clock();
        const auto begin = std::chrono::steady_clock::now();
        for (int step = 0; step < options.steps; ++step) nph_step(state, settings, scratch);
        cost.step_ns = 1e9 * seconds_since(begin) / options.steps / state.particles.size();
        cost.step_cpu_ns = 1e9 * static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC /
                           options.steps / state.particles.size();
        cost.times = scratch.times;
        cost.searches = scratch.lists.searches - searches;
        cost.refilters = scratch.lists.refilters - refilters;
        cost.coordination =
            2.0 * static_cast<double>(scratch.sums.contacts) / state.particles.size();
    });
    cost.hash = state_hash<Sphere>(state.particles.spheres);
    return cost;
}

double stage_ns(const SceneCost& cost, Stage stage, int steps, Index particles) {
    return 1e9 * cost.times.seconds[static_cast<std::size_t>(stage)] / steps / particles;
}

double most_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void print_row(const Options& options, const SceneCost& cost, Index particles) {
    const auto stage = [&](Stage one) { return stage_ns(cost, one, options.steps, particles); };
    fmt::print(
        "{:>6} {:>5} {:>9} {:>7} | {:>6.1f} {:>6.1f} | {:>6.1f} {:>6.1f} = {:>5.1f} {:>5.1f} "
        "{:>5.1f} "
        "{:>5.1f} | {:>5} {:>6} {:>5.2f} {:016x}\n",
        options.packing.size_ratio, options.packing.alpha, particles, cost.threads, cost.build_ns,
        cost.force_ns, cost.step_cpu_ns, cost.step_ns, stage(Stage::search), stage(Stage::refilter),
        stage(Stage::forces), stage(Stage::integrate), cost.searches, cost.refilters,
        cost.coordination, cost.hash);
}

nlohmann::json as_json(const Options& options, const SceneCost& cost, Index particles) {
    return {{"lambda", options.packing.size_ratio},
            {"alpha", options.packing.alpha},
            {"particles", particles},
            {"threads", cost.threads},
            {"build_ns", cost.build_ns},
            {"force_ns", stage_ns(cost, Stage::forces, options.steps, particles)},
            {"step_ns", cost.step_ns},
            {"step_cpu_ns", cost.step_cpu_ns},
            {"searches", cost.searches},
            {"memory_bytes", most_memory_bytes()},
            {"hash", fmt::format("{:016x}", cost.hash)}};
}

void write_data(const Options& options, const Scene& scene, const JamState& packing) {
    if (options.lammps_data.empty()) return;
    const JamState state = at_rest(packing, scene);
    Packing saved = to_packing(state, scene);
    saved.velocities.clear();
    write_lammps_data(saved, options.lammps_data);
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app{
        "Cost of a run, ns a particle: a build and a force evaluation alone, a step by "
        "stage (search, refilter, forces, integrate)."};
    app.add_option("--lambda", options.packing.size_ratio, "size ratio; 1: equal spheres");
    app.add_option("--alpha", options.packing.alpha, "exponent of the power law");
    app.add_option("--n", options.packing.count, "particles of the compressed packing");
    app.add_option("--replicas", options.packing.replicas, "copies of it along each edge");
    app.add_option("--steps", options.steps, "to measure")->check(CLI::PositiveNumber);
    app.add_option("--threads", options.threads, "one run for each")->delimiter(',');
    app.add_option("--masses", options.masses, "true (with the paper's time step) or diameter")
        ->check(CLI::IsMember({"true", "diameter"}));
    app.add_option("--lammps-data", options.lammps_data, "file to write the packing to");
    app.add_option("--json", options.json, "file for the results");
    CLI11_PARSE(app, argc, argv);

    const Scene scene = measured_scene(options);
    const JamState packing = dense_packing(options.packing);
    write_data(options, scene, packing);
    const Index particles = packing.particles.size();
    fmt::print(
        "lambda alpha         n threads |  build  force |    cpu   wall = search refil force integ "
        "|"
        " searches refilters Z hash\n");
    nlohmann::json rows = nlohmann::json::array();
    for (const int threads : options.threads) {
        const SceneCost cost = measure(options, scene, packing, threads);
        print_row(options, cost, particles);
        rows.push_back(as_json(options, cost, particles));
    }
    fmt::print("most memory in use: {:.0f} bytes a particle, a copy of the packing in\n",
               most_memory_bytes() / particles);
    if (options.json.empty()) return 0;
    std::ofstream out(options.json);
    out << rows.dump(2) << "\n";
    if (!out.flush()) throw FileError(fmt::format("{}: cannot be written", options.json));
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
