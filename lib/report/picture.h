// SPDX-License-Identifier: BSD-3-Clause
// A picture of a packing: real spheres in soft light, with a legend.
#pragma once

#include "packing/packing.h"
#include "report/appearance.h"
#include "report/canvas.h"
#include "report/visible_scene.h"

namespace jam {

struct PictureSettings {
    int width = 1600;
    int height = 1200;
    int samples = 32;  ///< rays a pixel; powers of two are spread best
    bool legend = true;
    SceneSettings scene;
};

/// Draws the packing on white. The same bits for any number of threads. Throws InputError for a
/// size that is not within 16..16384 pixels, samples not within 1..65536, a slice outside (0, 1),
/// or a packing without a visible sphere.
Bitmap render_picture(const Packing& packing, const Appearance& appearance,
                      const PictureSettings& settings = {});

}  // namespace jam
