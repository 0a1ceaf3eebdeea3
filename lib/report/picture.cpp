// SPDX-License-Identifier: BSD-3-Clause
#include "report/picture.h"

#include "core/check.h"
#include "core/parallel.h"
#include "report/color_bar.h"
#include "report/shading.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

constexpr Rgb background{1.0F, 1.0F, 1.0F};
/// White around the packing, over the picture's height.
constexpr double margin = 0.035;

void check(const PictureSettings& settings) {
    const auto good_size = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
    require(good_size(settings.width) && good_size(settings.height),
            "size {}x{}: width and height must be 16 to 16384 pixels", settings.width,
            settings.height);
    require(settings.samples >= 1 && settings.samples <= 65536,
            "samples {}: must be 1 to 65536; 32 is good, 256 for print", settings.samples);
    for (const Slice& slice : settings.scene.slices)
        require(slice.position > 0.0 && slice.position < 1.0,
                "slice {}={}: a slice lies at a fraction of the cell between 0 and 1, such as 0.5",
                "xyz"[slice.axis], slice.position);
}

/// A sample's place within two pixels, with the weights of a tent: smooth edges without blur.
double tent(double u) {
    return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
}

/// What one picture is drawn with; `width` is that of the part beside the legend.
struct Studio {
    const VisibleScene& scene;
    std::span<const Rgb> colors;
    Camera camera;
    Lights lights;
    int width;
    int height;
    int samples;
};

Rgb pixel_light(const Studio& studio, int x, int y) {
    const auto pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(studio.width) +
                       static_cast<std::uint64_t>(x);
    const PixelSamples samples(pixel);
    const double scale = (1.0 + 2.0 * margin) / studio.height;
    Rgb sum;
    for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(studio.samples); ++n) {
        const auto [u, v] = samples.point(SampleUse::pixel, n);
        const double across = (x + 0.5 + tent(u) - 0.5 * studio.width) * scale;
        const double upwards = (0.5 * studio.height - y - 0.5 - tent(v)) * scale;
        const auto light = light_along(studio.camera.ray_through(across, upwards), studio.scene,
                                       studio.colors, studio.lights, samples, n);
        sum = sum + light.value_or(background);
    }
    return (1.0F / static_cast<float>(studio.samples)) * sum;
}

}  // namespace

Bitmap render_picture(const Packing& packing, const Appearance& appearance,
                      const PictureSettings& settings) {
    check(settings);
    const VisibleScene scene = visible_scene(packing, appearance.hidden, settings.scene);
    require(!scene.sphere_of_ball.empty(), "picture: there is no sphere to see");
    Canvas canvas(settings.width, settings.height, background);
    const int legend = settings.legend ? legend_width(appearance.legend, settings.height) : 0;
    const int width = std::max(settings.width / 2, settings.width - legend);
    const Camera camera =
        frame(scene.outline, settings.scene.view, static_cast<double>(width) / settings.height);
    const Studio studio{scene, appearance.colors, camera,          Lights(camera),
                        width, settings.height,   settings.samples};
    for_each_block(settings.height, 1, [&](Count row, Count, Count) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) canvas.at(x, y) = pixel_light(studio, x, y);
    });
    if (settings.legend) draw_legend(canvas, appearance.legend);
    return encoded(canvas);
}

}  // namespace jam
