// SPDX-License-Identifier: BSD-3-Clause
#include "placement/random_start.h"

#include "core/check.h"
#include "neighbors/brute_force_neighbors.h"
#include "sizes/draw_diameters.h"

#include <gtest/gtest.h>

namespace jam {
namespace {

std::vector<double> power_law(double size_ratio, Count count) {
    PowerLaw law;
    law.size_ratio = size_ratio;
    law.alpha = 0.6;
    return draw_diameters(law, count, DrawMethod::stratified, 1);
}

TEST(RandomStart, HasTheVolumeFractionAndNoOverlap) {
    for (const double size_ratio : {1.5, 10.0}) {
        const std::vector<double> diameters = power_law(size_ratio, 1500);
        const RandomStart start = place_at_random(diameters, {.volume_fraction = 0.35, .seed = 4});
        double volume = 0.0;
        std::vector<Sphere> spheres;
        for (std::size_t i = 0; i < diameters.size(); ++i) {
            volume += sphere_volume(diameters[i]);
            spheres.push_back({start.centers[i], diameters[i]});
            EXPECT_TRUE(start.centers[i] == wrapped(start.centers[i]));
        }
        EXPECT_NEAR(volume / start.cell.volume(), 0.35, 1e-12);
        EXPECT_TRUE(brute_force_neighbors(start.cell, spheres).empty());
        EXPECT_GT(brute_force_neighbors(start.cell, spheres, 0.1).size(), 100u);
    }
}

TEST(RandomStart, SeedsDifferAndRepeat) {
    const std::vector<double> diameters(100, 1.0);
    const auto centers = [&](std::uint64_t seed) {
        return place_at_random(diameters, {.volume_fraction = 0.2, .seed = seed}).centers;
    };
    EXPECT_EQ(centers(1), centers(1));
    EXPECT_NE(centers(1), centers(2));
}

TEST(RandomStart, SaysWhyItCannotBe) {
    const std::vector<double> diameters(50, 1.0);
    EXPECT_THROW(place_at_random(diameters, {.volume_fraction = 0.7, .most_tries = 1000}),
                 InputError);
    EXPECT_THROW(place_at_random(diameters, {.volume_fraction = 0.0}), InputError);
    EXPECT_THROW(place_at_random({}, {}), InputError);
    EXPECT_THROW(place_at_random(std::vector<double>{1.0}, {.volume_fraction = 0.6}), InputError);
}

}  // namespace
}  // namespace jam
