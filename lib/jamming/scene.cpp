// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene.h"

namespace jam {

Count particle_count(const SizesSettings& sizes) {
    return sizes.count ? *sizes.count : particle_count(sizes.distribution);
}

std::vector<double> draw_diameters(const Scene& scene) {
    const SizesSettings& sizes = scene.sizes;
    return draw_diameters(sizes.distribution, particle_count(sizes), sizes.draw, scene.run.seed);
}

}  // namespace jam
