// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene.h"

namespace jam {

void take_defaults_of_accuracy(Scene& scene) {
    const Scene standard;
    DescentSettings& descent = scene.protocol.descent;
    descent = standard.protocol.descent;
    scene.stop.pressure = standard.stop.pressure;
    scene.stop.cundall = standard.stop.cundall;
    scene.stop.stability = standard.stop.stability;
    switch (scene.protocol.accuracy) {
        case Accuracy::fast:
            descent.compaction_steps = 3'000;
            descent.rate = 3e-3;
            descent.cundall = 3e-2;
            scene.stop.pressure = 1e-2;
            scene.stop.cundall = 1e-2;
            scene.stop.stability = false;
            break;
        case Accuracy::standard:
            break;
        case Accuracy::paper:
            descent.rate = 3e-5;
            descent.cundall = 3e-4;
            break;
    }
}

Count particle_count(const SizesSettings& sizes) {
    return sizes.count ? *sizes.count : particle_count(sizes.distribution);
}

std::vector<double> draw_diameters(const Scene& scene) {
    const SizesSettings& sizes = scene.sizes;
    return draw_diameters(sizes.distribution, particle_count(sizes), sizes.draw, scene.run.seed);
}

}  // namespace jam
