// SPDX-License-Identifier: BSD-3-Clause
#include "report/shading.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

// The balance of the lights, chosen by eye so that a lit face has about the color of the legend.
constexpr double sky_above = 0.98;
constexpr double sky_below = 0.42;
constexpr double lamp_strength = 0.62;
constexpr double lamp_cap_cosine = 0.975;  // a lamp 26 degrees wide: soft shadows
constexpr double passed_on = 0.55;         // light that a neighbor passes on over that of the sky
constexpr double gloss_strength = 0.10;
constexpr double gloss_exponent = 40.0;
constexpr Rgb edge_color{0.05F, 0.055F, 0.065F};

/// Rays start this far off the surface, over the size of what they leave.
constexpr double lift = 1e-3;

double sky(const Lights& lights, const Vec3& direction) {
    const double height = 0.5 + 0.5 * direction.dot(lights.up);
    return sky_below + (sky_above - sky_below) * height;
}

Rgb color_of(const Surface& surface, std::span<const Rgb> colors) {
    return surface.sphere < 0 ? edge_color : colors[surface.sphere];
}

Ray leaving(const Surface& surface, const Vec3& direction) {
    return {surface.point + lift * surface.size * surface.normal, direction};
}

/// Light from the sky, or from the neighbor that hides it.
Rgb ambient_light(const Surface& surface, const VisibleScene& scene, std::span<const Rgb> colors,
                  const Lights& lights, const std::array<double, 2>& uv) {
    const Vec3 direction = cosine_direction(uv, surface.normal);
    const double open_sky = sky(lights, direction);
    const auto neighbor = first_sphere(scene, leaving(surface, direction));
    if (!neighbor) return static_cast<float>(open_sky) * Rgb{1.0F, 1.0F, 1.0F};
    return static_cast<float>(passed_on * open_sky) * color_of(*neighbor, colors);
}

struct LampLight {
    float diffuse = 0.0F;
    float gloss = 0.0F;
};

LampLight lamp_light(const Surface& surface, const VisibleScene& scene, const Lights& lights,
                     const std::array<double, 2>& uv) {
    const Vec3 to_lamp = cap_direction(uv, lights.to_lamp, lamp_cap_cosine);
    const double cosine = surface.normal.dot(to_lamp);
    if (cosine <= 0.0 || is_blocked(scene, leaving(surface, to_lamp))) return {};
    const Vec3 half_way = (to_lamp + lights.to_viewer).normalized();
    const double gloss = std::pow(std::max(0.0, surface.normal.dot(half_way)), gloss_exponent);
    return {static_cast<float>(lamp_strength * cosine), static_cast<float>(gloss_strength * gloss)};
}

}  // namespace

Lights::Lights(const Camera& camera)
    : up((camera.up + 0.35 * camera.backward).normalized()),
      to_lamp((-0.55 * camera.right + 0.80 * camera.up + 0.75 * camera.backward).normalized()),
      to_viewer(camera.backward) {}

std::optional<Rgb> light_along(const Ray& ray, const VisibleScene& scene,
                               std::span<const Rgb> colors, const Lights& lights,
                               const PixelSamples& samples, std::uint32_t number) {
    const auto surface = first_surface(scene, ray);
    if (!surface) return std::nullopt;
    const LampLight lamp =
        lamp_light(*surface, scene, lights, samples.point(SampleUse::lamp, number));
    const Rgb ambient =
        ambient_light(*surface, scene, colors, lights, samples.point(SampleUse::sky, number));
    const Rgb light = ambient + lamp.diffuse * Rgb{1.0F, 0.985F, 0.955F};
    return color_of(*surface, colors) * light + lamp.gloss * Rgb{1.0F, 1.0F, 1.0F};
}

}  // namespace jam
