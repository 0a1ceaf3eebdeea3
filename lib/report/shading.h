// SPDX-License-Identifier: BSD-3-Clause
// How much light a surface sends to the viewer: a soft sky all around, one soft lamp above the
// viewer's left shoulder, and the light that neighbors pass on.
#pragma once

#include "report/canvas.h"
#include "report/sampling.h"
#include "report/visible_scene.h"

#include <span>

namespace jam {

/// Directions are those of the camera, so that every view is lit alike.
struct Lights {
    Vec3 up;
    Vec3 to_lamp;
    Vec3 to_viewer;

    explicit Lights(const Camera& camera);
};

/// The light along `ray` from the scene, or nothing where the background shows. `colors`: one a
/// sphere. Draws sample `number` of the pixel.
std::optional<Rgb> light_along(const Ray& ray, const VisibleScene& scene,
                               std::span<const Rgb> colors, const Lights& lights,
                               const PixelSamples& samples, std::uint32_t number);

}  // namespace jam
