// SPDX-License-Identifier: BSD-3-Clause
// What a scene will come to, told before it runs.
#pragma once

#include "grids/size_collections.h"
#include "jamming/scene.h"

namespace jam {

struct SceneForecast {
    Count particle_count = 0;
    double smallest_diameter = 0.0;
    double largest_diameter = 0.0;
    double start_volume_fraction = 0.0;
    double start_cell_edge = 0.0;         ///< cube root of the first cell's volume
    double jammed_volume_fraction = 0.0;  ///< by the rod model (sizes/rod_packing.h), +-0.01
    double jammed_cell_edge = 0.0;  ///< cube root of the cell's volume at that volume fraction
    SizeCollections collections;
};

/// Draws the diameters, or reads those of the packing that the scene starts from. Throws InputError
/// or FileError if there are none.
SceneForecast forecast(const Scene& scene);

}  // namespace jam
