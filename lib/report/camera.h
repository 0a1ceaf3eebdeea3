// SPDX-License-Identifier: BSD-3-Clause
// Where a picture is seen from.
#pragma once

#include "report/ray_scene.h"

#include <span>

namespace jam {

/// The side from which the cell is seen: angles in degrees. Azimuth 0 is from +x, 90 from +y;
/// elevation 90 from above (+z).
struct View {
    double azimuth = -62.0;
    double elevation = 24.0;
};

/// A pinhole camera. A picture is 1 high and `aspect` wide around its middle; x to the right, y up.
struct Camera {
    Vec3 eye;
    Vec3 right, up, backward;  ///< unit vectors; `backward` points from the scene to the viewer
    double half_height;        ///< of the picture at distance 1

    Ray ray_through(double x, double y) const;
};

/// Unit vector towards the viewer.
Vec3 direction_to_viewer(const View& view);

/// The camera that looks from `view`, as close as it can be with all `balls` inside the picture.
/// `aspect` is width over height. `balls` must not be empty.
Camera frame(std::span<const Ball> balls, const View& view, double aspect);

}  // namespace jam
