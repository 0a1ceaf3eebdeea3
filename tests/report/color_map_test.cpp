// SPDX-License-Identifier: BSD-3-Clause
#include "report/color_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace jam {
namespace {

constexpr int steps = 200;

double luminance(const Rgb& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

double distance(const Oklab& x, const Oklab& y) {
    return std::hypot(x.lightness - y.lightness, x.a - y.a, x.b - y.b);
}

/// What someone without the long- or the middle-wave cones sees (F. Vienot, H. Brettel and J. D.
/// Mollon, Color Res. Appl. 24, 243, 1999, in linear RGB).
Rgb without_red_cones(const Rgb& c) {
    const float yellow = 0.11238F * c.r + 0.88762F * c.g;
    return {yellow, yellow, 0.00401F * c.r - 0.00401F * c.g + c.b};
}
Rgb without_green_cones(const Rgb& c) {
    const float yellow = 0.29275F * c.r + 0.70725F * c.g;
    return {yellow, yellow, -0.02234F * c.r + 0.02234F * c.g + c.b};
}

TEST(ColorMap, SrgbBytesOfKnownLight) {
    EXPECT_EQ(hex_color({0.0F, 0.0F, 0.0F}), "#000000");
    EXPECT_EQ(hex_color({1.0F, 2.0F, 1.0F}), "#ffffff");
    EXPECT_EQ(hex_color({0.2158605F, 0.0F, 0.0021265F}), "#800007");  // IEC 61966-2-1
}

TEST(ColorMap, OklabThereAndBack) {
    const Oklab white = oklab_from_rgb({1.0F, 1.0F, 1.0F});
    EXPECT_NEAR(white.lightness, 1.0, 1e-4);
    EXPECT_NEAR(std::hypot(white.a, white.b), 0.0, 1e-4);
    for (const Rgb& color : {Rgb{0.9F, 0.1F, 0.3F}, Rgb{0.02F, 0.5F, 0.7F}}) {
        const Rgb back = rgb_from_oklab(oklab_from_rgb(color));
        EXPECT_NEAR(back.r, color.r, 1e-5);
        EXPECT_NEAR(back.g, color.g, 1e-5);
        EXPECT_NEAR(back.b, color.b, 1e-5);
    }
}

TEST(ColorMap, ScaleGetsLighterForEveryEye) {
    for (int i = 0; i < steps; ++i) {
        const Rgb darker = scale_color(static_cast<double>(i) / steps);
        const Rgb lighter = scale_color((i + 1.0) / steps);
        EXPECT_LT(oklab_from_rgb(darker).lightness, oklab_from_rgb(lighter).lightness);
        EXPECT_LT(luminance(darker), luminance(lighter));
        EXPECT_LT(luminance(without_red_cones(darker)), luminance(without_red_cones(lighter)));
        EXPECT_LT(luminance(without_green_cones(darker)), luminance(without_green_cones(lighter)));
    }
}

TEST(ColorMap, EqualStepsLookEquallyFarApart) {
    double smallest = 1.0;
    double largest = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double step = distance(oklab_from_rgb(scale_color(static_cast<double>(i) / steps)),
                                     oklab_from_rgb(scale_color((i + 1.0) / steps)));
        smallest = std::min(smallest, step);
        largest = std::max(largest, step);
    }
    EXPECT_LT(largest / smallest, 1.3);  // the table of 1024 colors rounds each end of a step
    EXPECT_GT(smallest * steps, 0.6);    // from nearly black to nearly white
}

TEST(ColorMap, ScaleStaysWithinWhatAScreenShows) {
    for (int i = 0; i <= steps; ++i) {
        const Rgb color = scale_color(static_cast<double>(i) / steps);
        for (const float channel : {color.r, color.g, color.b}) {
            EXPECT_GE(channel, 0.0F) << i;
            EXPECT_LE(channel, 1.0F) << i;
        }
    }
}

TEST(ColorMap, BeyondItsEndsTheScaleKeepsTheColorOfTheEnd) {
    EXPECT_EQ(hex_color(scale_color(-3.0)), hex_color(scale_color(0.0)));
    EXPECT_EQ(hex_color(scale_color(7.0)), hex_color(scale_color(1.0)));
}

TEST(ColorMap, KindsAreDistinctAndComeAgain) {
    std::set<std::string> colors;
    for (int kind = 0; kind < 8; ++kind) colors.insert(hex_color(kind_color(kind)));
    EXPECT_EQ(colors.size(), 8u);
    EXPECT_EQ(hex_color(kind_color(8)), hex_color(kind_color(0)));
}

}  // namespace
}  // namespace jam
