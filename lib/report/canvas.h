// SPDX-License-Identifier: BSD-3-Clause
// A picture in memory: linear light while it is made, eight bits a channel when it is done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jam {

/// Linear light (not gamma-encoded), 0 black to 1 white in each channel.
struct Rgb {
    float r = 0.0F, g = 0.0F, b = 0.0F;
};

constexpr Rgb operator+(const Rgb& a, const Rgb& b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Rgb operator*(const Rgb& a, const Rgb& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Rgb operator*(float s, const Rgb& a) {
    return {s * a.r, s * a.g, s * a.b};
}
constexpr Rgb blend(const Rgb& under, const Rgb& over, float coverage) {
    return (1.0F - coverage) * under + coverage * over;
}

/// Pixels in rows from the top left.
struct Canvas {
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;

    Canvas(int columns, int rows, const Rgb& fill)
        : width(columns),
          height(rows),
          pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}

    Rgb& at(int x, int y) { return pixels[place(x, y)]; }
    const Rgb& at(int x, int y) const { return pixels[place(x, y)]; }

  private:
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// Three bytes (red, green, blue; sRGB) a pixel, rows from the top left.
struct Bitmap {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes;
};

/// The canvas in sRGB (IEC 61966-2-1), values beyond [0, 1] clipped.
Bitmap encoded(const Canvas& canvas);

}  // namespace jam
