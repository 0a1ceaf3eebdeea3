// SPDX-License-Identifier: BSD-3-Clause
// The colors of every picture and figure: one sequential scale for quantities, one set of distinct
// colors for kinds of things. Both stay readable for the color-blind and in grey.
#pragma once

#include "report/canvas.h"

#include <array>
#include <cstdint>
#include <string>

namespace jam {

/// sRGB bytes of linear light, clipped to [0, 1].
std::array<std::uint8_t, 3> srgb_bytes(const Rgb& color);

/// "#rrggbb"
std::string hex_color(const Rgb& color);

/// A color in Oklab (B. Ottosson, "A perceptual color space for image processing", 2020):
/// lightness 0..1, then green-red and blue-yellow.
struct Oklab {
    double lightness, a, b;
};
Rgb rgb_from_oklab(const Oklab& color);
Oklab oklab_from_rgb(const Rgb& color);

/// The sequential scale at `t` in [0, 1] (clipped): from deep indigo through teal to pale yellow,
/// lightness rising all the way and equal steps of t looking equally far apart.
Rgb scale_color(double t);

/// Distinct color number `kind` (0..7, then again from the start): M. Okabe and K. Ito, "Color
/// universal design", 2008, ordered so that the first ones differ most.
Rgb kind_color(int kind);

/// What has no value on the scale.
Rgb neutral_color();

}  // namespace jam
