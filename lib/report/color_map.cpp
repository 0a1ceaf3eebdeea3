// SPDX-License-Identifier: BSD-3-Clause
#include "report/color_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

double srgb_encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

double srgb_decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Rgb from_hex(std::uint32_t hex) {
    const auto channel = [&](int shift) {
        return static_cast<float>(srgb_decoded(((hex >> shift) & 0xffU) / 255.0));
    };
    return {channel(16), channel(8), channel(0)};
}

// Where the scale passes, chosen by eye; lightness rises evenly between the ends. A uniform cubic
// B-spline smooths the path, so that it only passes near the inner points.
constexpr std::array<Oklab, 6> scale_points = {{{0.270, 0.030, -0.120},
                                                {0.403, -0.010, -0.125},
                                                {0.536, -0.065, -0.060},
                                                {0.669, -0.105, 0.020},
                                                {0.802, -0.085, 0.120},
                                                {0.935, -0.022, 0.118}}};
constexpr int scale_spans = static_cast<int>(scale_points.size()) - 1;

Oklab operator+(const Oklab& x, const Oklab& y) {
    return {x.lightness + y.lightness, x.a + y.a, x.b + y.b};
}
Oklab operator-(const Oklab& x, const Oklab& y) {
    return {x.lightness - y.lightness, x.a - y.a, x.b - y.b};
}
Oklab operator*(double s, const Oklab& x) {
    return {s * x.lightness, s * x.a, s * x.b};
}
double length(const Oklab& x) {
    return std::sqrt(x.lightness * x.lightness + x.a * x.a + x.b * x.b);
}

/// Control point `i`; beyond an end the path goes straight on, so that it starts and stops there.
Oklab control_point(int i) {
    if (i < 0) return 2.0 * scale_points.front() - scale_points[1];
    if (i > scale_spans) return 2.0 * scale_points.back() - scale_points[scale_spans - 1];
    return scale_points[i];
}

Oklab spline(double u) {
    const int span = std::clamp(static_cast<int>(std::floor(u)), 0, scale_spans - 1);
    const double x = u - span;
    const double y = 1.0 - x;
    return (y * y * y / 6.0) * control_point(span - 1) +
           ((3.0 * x * x * x - 6.0 * x * x + 4.0) / 6.0) * control_point(span) +
           ((3.0 * y * y * y - 6.0 * y * y + 4.0) / 6.0) * control_point(span + 1) +
           (x * x * x / 6.0) * control_point(span + 2);
}

/// The scale in steps of equal length along the path: equal steps look equally far apart.
constexpr int table_steps = 1024;
std::array<Rgb, table_steps + 1> make_scale_table() {
    constexpr int fine_steps = 16 * table_steps;
    const auto at = [](int i) { return spline(scale_spans * static_cast<double>(i) / fine_steps); };
    double whole = 0.0;
    for (int i = 0; i < fine_steps; ++i) whole += length(at(i + 1) - at(i));
    std::array<Rgb, table_steps + 1> table;
    double walked = 0.0;
    int step = 0;
    for (int i = 0; i <= fine_steps && step <= table_steps; ++i) {
        if (walked >= whole * step / table_steps - 1e-12 || i == fine_steps)
            table[static_cast<std::size_t>(step++)] = rgb_from_oklab(at(i));
        walked += length(at(i + 1) - at(i));
    }
    return table;
}

}  // namespace

std::array<std::uint8_t, 3> srgb_bytes(const Rgb& color) {
    const auto byte = [](float linear) {
        return static_cast<std::uint8_t>(std::lround(255.0 * srgb_encoded(linear)));
    };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

std::string hex_color(const Rgb& color) {
    const auto [r, g, b] = srgb_bytes(color);
    return fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
}

Rgb rgb_from_oklab(const Oklab& c) {
    const double l = std::pow(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
    const double m = std::pow(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
    const double s = std::pow(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
    return {static_cast<float>(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            static_cast<float>(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            static_cast<float>(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Oklab oklab_from_rgb(const Rgb& c) {
    const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgb scale_color(double t) {
    static const std::array<Rgb, table_steps + 1> table = make_scale_table();
    const double step = std::clamp(t, 0.0, 1.0) * table_steps;
    return table[static_cast<std::size_t>(std::lround(step))];
}

Rgb kind_color(int kind) {
    constexpr std::array<std::uint32_t, 8> okabe_ito = {0x0072b2, 0xd55e00, 0x009e73, 0xe69f00,
                                                        0xcc79a7, 0x56b4e9, 0x000000, 0xf0e442};
    return from_hex(okabe_ito[static_cast<std::size_t>(kind) % okabe_ito.size()]);
}

Rgb neutral_color() {
    return from_hex(0xb8bcc2);
}

}  // namespace jam
