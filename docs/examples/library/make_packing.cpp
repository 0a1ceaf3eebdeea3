// SPDX-License-Identifier: BSD-3-Clause
// Makes a packing: a scene as a struct, a start, the protocol, a file.
//     make_packing packing.h5
#include "jamming/jam_packing.h"
#include "jamming/jammed_file.h"

#include <cstdio>

static jam::Scene scene() {
    jam::Scene scene;
    scene.sizes.distribution = jam::PowerLaw{.size_ratio = 2.0, .alpha = 0.5};
    scene.sizes.count = 200;
    scene.protocol.pressure = jam::Mat3::Identity() * 1e-2;  // high, so that this takes a second
    scene.protocol.masses = jam::Masses::diameter;
    scene.stop.cundall = 1e-4;
    scene.stop.kinetic_energy = 1e-8;
    scene.stop.window = 2000;
    return scene;
}

int main(int argc, char** argv) try {
    const jam::Scene wanted = scene();
    jam::JamState state = jam::start_state(wanted);
    jam::JamHooks hooks;
    hooks.on_record = [](const jam::Record& record, const jam::Verdict&) {
        std::printf("step %6lld  phi %.5f\n", static_cast<long long>(record.step),
                    record.volume_fraction);
    };
    const jam::JamResult result = jam::jam_packing(wanted, state, hooks);
    jam::save_jammed(result, argc > 1 ? argv[1] : "packing.h5");
    std::printf("%s\n%s", result.verdict.converged() ? "jammed" : "not jammed",
                jam::to_text(result.verdict).c_str());
    return result.verdict.converged() ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
