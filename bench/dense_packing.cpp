// SPDX-License-Identifier: BSD-3-Clause
#include "dense_packing.h"

#include "jamming/nph_step.h"
#include "packing/packing_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace jam::bench {

namespace {

void compress(JamState& state, const Scene& scene) {
    const NphSettings settings = nph_settings(scene, state);
    NphScratch scratch(diameters_by_id(state.particles), {});
    begin_nph(state, settings, scratch);
    double before = state.cell.volume();
    for (;;) {
        for (int step = 0; step < 500; ++step) nph_step(state, settings, scratch);
        const double now = state.cell.volume();
        if (state.step >= 2000 && now > 0.999 * before) return;
        before = now;
    }
}

}  // namespace

Scene bench_scene(const DensePacking& wanted) {
    Scene scene;
    if (wanted.size_ratio > 1.0) {
        PowerLaw law;
        law.size_ratio = wanted.size_ratio;
        law.alpha = wanted.alpha;
        scene.sizes.distribution = law;
    } else {
        scene.sizes.distribution = Monodisperse{};
    }
    scene.sizes.count = wanted.count;
    scene.protocol.pressure = Mat3::Identity() * 1e-3;
    scene.protocol.masses = Masses::diameter;
    return scene;
}

JamState dense_packing(const DensePacking& wanted) {
    const std::filesystem::path folder = "build/bench_packings";
    const std::filesystem::path file =
        folder /
        fmt::format("lambda{}_alpha{}_n{}.h5", wanted.size_ratio, wanted.alpha, wanted.count);
    Scene scene = bench_scene(wanted);
    if (!std::filesystem::exists(file)) {
        JamState state = start_state(scene);
        compress(state, scene);
        std::filesystem::create_directories(folder);
        save_packing(to_packing(state, scene), file);
    }
    scene.start.packing = file;
    return start_state(scene);
}

}  // namespace jam::bench
