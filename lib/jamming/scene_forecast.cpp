// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene_forecast.h"

#include "neighbors/verlet_lists.h"
#include "packing/packing_file.h"
#include "particles/particles.h"
#include "sizes/rod_packing.h"

#include <algorithm>
#include <cmath>

namespace jam {

static double edge(double particle_volume, double volume_fraction) {
    return std::cbrt(particle_volume / volume_fraction);
}

static double volume_of(const std::vector<double>& diameters) {
    double sum = 0.0;
    for (const double diameter : diameters) sum += sphere_volume(diameter);
    return sum;
}

SceneForecast forecast(const Scene& scene) {
    Packing start;
    const bool from_packing = !scene.start.packing.empty();
    if (from_packing) start = load_packing(scene.start.packing);
    const std::vector<double> diameters = from_packing ? start.diameters : draw_diameters(scene);
    const double volume = volume_of(diameters);

    SceneForecast out;
    out.particle_count = static_cast<Count>(diameters.size());
    const auto [smallest, largest] = std::ranges::minmax_element(diameters);
    out.smallest_diameter = *smallest;
    out.largest_diameter = *largest;
    out.start_volume_fraction =
        from_packing ? volume / start.cell.volume() : scene.start.volume_fraction;
    out.start_cell_edge = edge(volume, out.start_volume_fraction);
    out.jammed_volume_fraction = rod_packing_fraction(diameters);
    out.jammed_cell_edge = edge(volume, out.jammed_volume_fraction);
    out.collections = list_collections(diameters, scene.run.lists);
    return out;
}

}  // namespace jam
