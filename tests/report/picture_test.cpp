// SPDX-License-Identifier: BSD-3-Clause
// Pictures of tiny scenes, held against what geometry says must be seen.
#include "report/picture.h"

#include "core/check.h"
#include "core/parallel.h"
#include "report/color_map.h"
#include "support/packings.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace jam {
namespace {

using namespace test;

constexpr int side = 200;
/// How many pixels the packing's own height takes; the rest is margin.
constexpr double packing_pixels = side / 1.07;

PictureSettings plain(const View& view = {}) {
    PictureSettings settings{side, side, 16, false, {}};
    settings.scene.view = view;
    settings.scene.cell_edges = false;
    return settings;
}

using Pixel = std::array<int, 3>;

Pixel pixel(const Bitmap& picture, int x, int y) {
    const int at = 3 * (y * picture.width + x);
    return {picture.bytes[at], picture.bytes[at + 1], picture.bytes[at + 2]};
}

constexpr Pixel white = {255, 255, 255};

/// Area of a black picture's figure in pixels, those at its edge counted by what they hold.
double black_area(const Bitmap& picture) {
    double area = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            area += 1.0 - std::pow(pixel(picture, x, y)[2] / 255.0, 2.2);
    return area;
}

Appearance one_color(const Packing& packing, const Rgb& color) {
    return {std::vector<Rgb>(packing.diameters.size(), color), {}, KindLegend{}};
}

constexpr Rgb black{0.0F, 0.0F, 0.0F};
constexpr Rgb grey{0.4F, 0.4F, 0.4F};

Packing one_sphere(double diameter) {
    return make_packing(Mat3::Identity() * 10.0, {Vec3(5.0, 5.0, 5.0)}, {diameter});
}

double disk_area(double diameter) {
    return std::numbers::pi / 4.0 * diameter * diameter;
}

TEST(Picture, ASphereFillsItsFrameWithADisk) {
    const Packing packing = one_sphere(3.0);
    for (const View& view : {View{}, View{0.0, 0.0}, View{130.0, -50.0}, View{-90.0, 90.0}}) {
        const Bitmap picture = render_picture(packing, one_color(packing, black), plain(view));
        // A black sphere is only black but for its gloss.
        EXPECT_NEAR(black_area(picture), disk_area(packing_pixels),
                    0.02 * disk_area(packing_pixels));
        EXPECT_EQ(pixel(picture, 3, side / 2), white);
        EXPECT_NE(pixel(picture, side / 2, 9), white);
    }
}

TEST(Picture, ASliceThroughTheMiddleLeavesHalfADiskFromTheSide) {
    const Packing packing = one_sphere(3.0);
    PictureSettings settings = plain({-90.0, 0.0001});
    settings.scene.slices = {{2, 0.5}};
    const Bitmap picture = render_picture(packing, one_color(packing, black), settings);
    EXPECT_NEAR(black_area(picture), 0.5 * disk_area(packing_pixels),
                0.01 * disk_area(packing_pixels));
    EXPECT_EQ(pixel(picture, side / 2, side / 2 - 3), white);  // above the cut
    EXPECT_NE(pixel(picture, side / 2, side / 2 + 3), white);
}

TEST(Picture, ACutFaceIsFlat) {
    const Packing packing = one_sphere(3.0);
    PictureSettings settings = plain({-90.0, 90.0});
    settings.samples = 64;
    const auto contrast = [&] {
        const Bitmap picture = render_picture(packing, one_color(packing, grey), settings);
        return std::abs(pixel(picture, side / 2, side / 2)[0] -
                        pixel(picture, side / 2 + 80, side / 2)[0]);
    };
    EXPECT_GT(contrast(), 20);  // round: its edge turns away from the light
    settings.scene.slices = {{2, 0.5}};
    EXPECT_LE(contrast(), 3);
}

TEST(Picture, OverlappingSpheresAreCutCleanly) {
    const Packing packing = make_packing(Mat3::Identity() * 10.0,
                                         {Vec3(4.0, 5.0, 5.0), Vec3(6.0, 5.0, 5.0)}, {3.0, 3.0});
    PictureSettings settings = plain({-90.0, 90.0});
    settings.samples = 64;
    settings.scene.slices = {{2, 0.5}};
    const Bitmap picture = render_picture(packing, one_color(packing, grey), settings);
    for (int x = 20; x < side - 20; ++x)
        EXPECT_NEAR(pixel(picture, x, side / 2)[0], pixel(picture, 50, side / 2)[0], 3) << x;
}

TEST(Picture, CutAtTheFacesShowsThePiecesThatReachInFromOtherCells) {
    // One sphere on a corner of the cell: a quarter of a disk in each corner of every face.
    const Packing packing = make_packing(Mat3::Identity() * 10.0, {Vec3::Zero()}, {4.0});
    PictureSettings settings = plain({0.0, 0.0});
    settings.scene.cut_at_faces = true;
    const Bitmap picture = render_picture(packing, one_color(packing, grey), settings);
    const double pixels_per_length = packing_pixels / 10.0;
    const double corner = 0.5 * (side - packing_pixels);
    for (const double reach : {0.15, 1.0, 1.85}) {
        const int in = static_cast<int>(corner + pixels_per_length * reach / std::sqrt(2.0));
        const int out = side - 1 - in;
        for (const auto& [x, y] : {std::pair(in, in), {in, out}, {out, in}, {out, out}})
            EXPECT_NE(pixel(picture, x, y), white) << x << " " << y;
    }
    EXPECT_EQ(pixel(picture, side / 2, side / 2), white);
    const int outside = static_cast<int>(corner) - 3;
    EXPECT_EQ(pixel(picture, outside, outside), white);
}

TEST(Picture, ImagesOfAPackingLookAlike) {
    const Mat3 edges = (Mat3() << 10.0, 2.0, -1.0, 0.0, 9.0, 1.5, 0.0, 0.0, 8.0).finished();
    const std::vector<Vec3> centers = {Vec3(4.0, 3.0, 2.0), Vec3(5.0, 6.0, 6.0)};
    const std::vector<double> diameters = {2.0, 1.0};
    const Packing near = make_packing(edges, centers, diameters);
    const Packing far = make_packing(
        edges,
        {centers[0] + edges * Vec3(2.0, -1.0, 3.0), centers[1] - edges * Vec3(0.0, 4.0, 1.0)},
        diameters);
    const Bitmap one = render_picture(near, one_color(near, grey), plain());
    const Bitmap other = render_picture(far, one_color(far, grey), plain());
    int different = 0;
    for (std::size_t k = 0; k < one.bytes.size(); ++k)
        different += std::abs(one.bytes[k] - other.bytes[k]) > 2 ? 1 : 0;
    EXPECT_EQ(different, 0);
}

TEST(Picture, ColorsAreThoseOfTheKey) {
    const Packing packing = make_packing(Mat3::Identity() * 10.0,
                                         {Vec3(5.0, 2.0, 5.0), Vec3(5.0, 8.0, 5.0)}, {3.0, 3.0});
    const std::vector<double> values = {1.0, 100.0};
    PictureSettings settings = plain({0.0, 0.0});
    settings.samples = 64;
    const Bitmap picture = render_picture(packing, color_by_values(values, "value"), settings);
    // Seen from +x, +y is to the right; centers 6 apart in a picture 9 wide.
    const int left = static_cast<int>(side / 2 - packing_pixels / 3.0);
    const Pixel low = pixel(picture, left, side / 2);
    const Pixel high = pixel(picture, side - left, side / 2);
    EXPECT_GT(low[2], 2 * low[1]);                                 // indigo: blue above all
    EXPECT_TRUE(high[0] > 200 && high[1] > 180 && high[2] < 190);  // pale yellow
}

TEST(Picture, HiddenSpheresAreNotThere) {
    const Packing packing = make_packing(Mat3::Identity() * 10.0,
                                         {Vec3(5.0, 5.0, 5.0), Vec3(7.5, 5.0, 5.0)}, {3.0, 2.0});
    const Packing alone = one_sphere(3.0);
    Appearance appearance = one_color(packing, grey);
    appearance.hidden = {0, 1};
    EXPECT_EQ(render_picture(packing, appearance, plain()).bytes,
              render_picture(alone, one_color(alone, grey), plain()).bytes);
}

TEST(Picture, AValueThatIsNotThereIsNeutral) {
    const std::vector<double> values = {1.0, std::nan(""), 3.0};
    const Appearance appearance = color_by_values(values, "value");
    EXPECT_EQ(hex_color(appearance.colors[1]), hex_color(neutral_color()));
    EXPECT_EQ(hex_color(appearance.colors[2]), hex_color(scale_color(1.0)));
}

TEST(Picture, TheSameBitsForAnyNumberOfThreads) {
    const Packing packing = random_spheres(random_edges(12.0, 3), 1500, 8.0, 5);
    PictureSettings settings{240, 180, 4, true, {}};
    settings.scene.cut_at_faces = true;
    settings.scene.slices = {{2, 0.7}};
    const Appearance appearance = color_by_diameter(packing);
    const auto bytes = [&](int threads) {
        return run_with_threads(
            threads, [&] { return render_picture(packing, appearance, settings).bytes; });
    };
    const std::vector<std::uint8_t> one = bytes(1);
    EXPECT_EQ(bytes(2), one);
    EXPECT_EQ(bytes(3), one);
}

TEST(Picture, WhatCannotBeDrawnIsRefused) {
    const Packing packing = one_sphere(3.0);
    const Appearance appearance = one_color(packing, grey);
    PictureSettings wrong_size = plain();
    wrong_size.width = 3;
    EXPECT_THROW(render_picture(packing, appearance, wrong_size), InputError);
    PictureSettings wrong_slice = plain();
    wrong_slice.scene.slices = {{1, 1.5}};
    EXPECT_THROW(render_picture(packing, appearance, wrong_slice), InputError);
    Appearance nothing = appearance;
    nothing.hidden = {1};
    EXPECT_THROW(render_picture(packing, nothing, plain()), InputError);
}

}  // namespace
}  // namespace jam
