// SPDX-License-Identifier: BSD-3-Clause
#include "report/color_bar.h"

#include "report/color_map.h"
#include "report/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jam {
namespace {

using testing::ElementsAre;

std::vector<std::string> numbers(const ScaleLegend& scale) {
    std::vector<std::string> labels;
    for (const Tick& tick : scale_ticks(scale))
        if (!tick.label.empty()) labels.push_back(tick.label);
    return labels;
}

TEST(ColorBar, RoundNumbers) {
    EXPECT_THAT(numbers({"", 1.0000002, 49.7, true}), ElementsAre("1", "2", "5", "10", "20", "50"));
    EXPECT_THAT(numbers({"", 0.0003, 4.0, true}), ElementsAre("0.001", "0.01", "0.1", "1"));
    EXPECT_THAT(numbers({"", 1e-6, 1e-3, true}), ElementsAre("10^-6", "10^-5", "10^-4", "0.001"));
    EXPECT_THAT(numbers({"", 0.0, 1.0, false}), ElementsAre("0.0", "0.5", "1.0"));
    EXPECT_THAT(numbers({"", -3.0, 12.0, false}), ElementsAre("0", "5", "10"));
    EXPECT_THAT(numbers({"", 2.0, 2.0, false}), ElementsAre("2"));
}

TEST(ColorBar, MarksStandWhereTheirColorIs) {
    const ScaleLegend scale{"", 1.0, 100.0, true};
    EXPECT_DOUBLE_EQ(place_on_scale(scale, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(place_on_scale(scale, 10.0), 0.5);
    EXPECT_DOUBLE_EQ(place_on_scale(scale, 100.0), 1.0);
    EXPECT_DOUBLE_EQ(place_on_scale({"", 2.0, 6.0, false}, 3.0), 0.25);
}

TEST(ColorBar, TheBarRunsFromTheLowestColorUpToTheHighest) {
    const ScaleLegend scale{"title", 1.0, 100.0, true};
    Canvas canvas(300, 400, {1.0F, 1.0F, 1.0F});
    draw_legend(canvas, scale);
    const int x = canvas.width - legend_width(scale, canvas.height) + 3;
    std::vector<double> lightness;
    for (int y = 0; y < canvas.height; ++y) {
        const Oklab color = oklab_from_rgb(canvas.at(x, y));
        if (std::hypot(color.a, color.b) > 0.05) lightness.push_back(color.lightness);
    }
    ASSERT_GT(lightness.size(), 180u);
    EXPECT_TRUE(std::ranges::is_sorted(lightness, std::greater{}));
    EXPECT_NEAR(lightness.front(), oklab_from_rgb(scale_color(1.0)).lightness, 0.02);
    EXPECT_NEAR(lightness.back(), oklab_from_rgb(scale_color(0.0)).lightness, 0.02);
}

TEST(Drawing, InkIsWidthTimesLength) {
    Canvas canvas(100, 60, {0.0F, 0.0F, 0.0F});
    draw_stroke(canvas, {{20.3, 17.6}, {80.3, 41.6}}, 4.0, {1.0F, 1.0F, 1.0F});
    double ink = 0.0;
    for (const Rgb& pixel : canvas.pixels) ink += pixel.g;
    EXPECT_NEAR(ink, 4.0 * std::hypot(60.0, 24.0) + std::numbers::pi * 4.0, 1.0);
}

TEST(Drawing, ARectangleBetweenPixelsCoversItsArea) {
    Canvas canvas(20, 20, {0.0F, 0.0F, 0.0F});
    fill_rectangle(canvas, {3.25, 4.5}, {9.0, 6.75}, {1.0F, 1.0F, 1.0F});
    double ink = 0.0;
    for (const Rgb& pixel : canvas.pixels) ink += pixel.r;
    EXPECT_NEAR(ink, 5.75 * 2.25, 1e-4);
}

TEST(Drawing, TextStaysInsideItsWidth) {
    Canvas canvas(400, 40, {1.0F, 1.0F, 1.0F});
    const std::string text = "diameter 0.01 x 10^-3";
    draw_text(canvas, text, {380.0, 28.0}, 14.0, TextAlign::right, {0.0F, 0.0F, 0.0F});
    int left = canvas.width;
    int right = 0;
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x)
            if (canvas.at(x, y).r < 0.5F) {
                left = std::min(left, x);
                right = std::max(right, x);
            }
    EXPECT_NEAR(right, 380.0, 2.5);
    EXPECT_NEAR(left, 380.0 - text_width(text, 14.0), 2.5);
}

}  // namespace
}  // namespace jam
