// SPDX-License-Identifier: BSD-3-Clause
// A size distribution of one's own: any function from a share of the particles to a diameter makes
// one, as a list of diameters. Here the number density falls linearly from D = 1 to zero at D = 4.
#include "jamming/jam_state.h"
#include "sizes/rod_packing.h"
#include "sizes/size_table.h"

#include <cmath>
#include <cstdio>

/// The diameter below which a share u of the particles lies: 1 - u = ((4 - D) / 3)^2.
static double diameter_at(double u) {
    return 4.0 - 3.0 * std::sqrt(1.0 - u);
}

static jam::DiameterList falling_sizes(int count) {
    std::vector<double> diameters;
    for (int i = 0; i < count; ++i) diameters.push_back(diameter_at((i + 0.5) / count));
    return jam::diameter_list(std::move(diameters));
}

int main() try {
    jam::Scene scene;
    scene.sizes.distribution = falling_sizes(1000);
    scene.start.volume_fraction = 0.4;
    const jam::JamState start = jam::start_state(scene);
    std::printf("%lld spheres, mean diameter %.3f, mean volume %.2f\n",
                static_cast<long long>(start.particles.size()),
                jam::moment(scene.sizes.distribution, 1.0),
                jam::mean_volume(scene.sizes.distribution));
    std::printf(
        "placed at a volume fraction of 0.4 in a cell %.2f wide; expected when jammed: %.2f\n",
        start.cell.matrix()(0, 0), jam::rod_packing_fraction(scene.sizes.distribution));
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
