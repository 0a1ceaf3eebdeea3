// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/draw_diameters.h"

#include "core/check.h"
#include "core/parallel.h"
#include "sizes/size_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace jam {
namespace {

// Largest difference between the drawn and the analytic cumulative fraction, at 99 diameters.
double worst_difference(const SizeDistribution& sizes, std::vector<double> diameters,
                        Weight weight) {
    const SizeDistribution drawn = diameter_list(std::move(diameters));
    double worst = 0.0;
    for (int i = 1; i < 100; ++i) {
        const double diameter = quantile(sizes, weight, i / 100.0);
        worst = std::max(worst, std::abs(cumulative_fraction(drawn, weight, diameter) -
                                         cumulative_fraction(sizes, weight, diameter)));
    }
    return worst;
}

// Ten spheres hold the last 5 % of an alpha = 1 packing's volume: it steps by half a percent.
TEST(DrawDiameters, StratifiedFollowsTheCumulativeCurves) {
    for (const SizeDistribution& sizes :
         {SizeDistribution{PowerLaw{20.0, 1.0}}, SizeDistribution{PowerLaw{20.0, 0.3}},
          SizeDistribution{GrainSizeDistribution{10.0, 0.6}}, SizeDistribution{Lognormal{0.4}},
          SizeDistribution{cumulative_curve({1.0, 2.0, 6.0}, {0.0, 0.5, 1.0}, Weight::volume)}}) {
        const auto diameters = draw_diameters(sizes, particle_count(sizes));
        EXPECT_LT(worst_difference(sizes, diameters, Weight::number),
                  0.51 / static_cast<double>(diameters.size()));
        EXPECT_LT(worst_difference(sizes, diameters, Weight::volume), 0.005);
    }
}

TEST(DrawDiameters, RandomFollowsTheCumulativeCurves) {
    const SizeDistribution sizes = PowerLaw{5.0, 0.55};
    constexpr Count count = 100000;
    const auto diameters = draw_diameters(sizes, count, DrawMethod::random, 3);
    const double worst = worst_difference(sizes, diameters, Weight::number);
    EXPECT_LT(worst, 1.95 / std::sqrt(count));  // Kolmogorov-Smirnov, one in a thousand
    EXPECT_GT(worst, 0.05 / std::sqrt(count));  // not stratified
}

TEST(DrawDiameters, TheRuleReallyGivesTenLargeSpheres) {
    for (const double alpha : {-0.5, 0.0, 0.2, 0.55, 1.0, 2.0, 3.0, 4.0})
        for (const double size_ratio : {2.0, 5.0, 10.0, 20.0}) {
            const SizeDistribution sizes = PowerLaw{size_ratio, alpha};
            const Count count = particle_count(sizes);
            if (count > 2'000'000) continue;
            const auto large = std::ranges::count_if(
                draw_diameters(sizes, count), [&](double d) { return d > 0.95 * size_ratio; });
            EXPECT_GE(large, 10) << "alpha " << alpha << ", size ratio " << size_ratio;
            EXPECT_LE(large, 11) << "alpha " << alpha << ", size ratio " << size_ratio;
        }
}

TEST(DrawDiameters, BinaryNumbersAreExact) {
    for (const double small_fraction : {0.01, 0.265, 0.5, 0.9})
        for (const Count large_count : {1, 7, 300}) {
            const Binary binary{5.0, small_fraction, large_count};
            const auto diameters = draw_diameters(binary, particle_count(binary));
            EXPECT_EQ(std::ranges::count(diameters, 5.0), large_count);
            EXPECT_EQ(std::ranges::count(diameters, 1.0),
                      std::llround(static_cast<double>(large_count) * 125.0 * small_fraction /
                                   (1.0 - small_fraction)));
        }
}

TEST(DrawDiameters, AListIsDrawnOnceEach) {
    const std::vector<double> given = {3.0, 1.0, 2.5, 2.0, 2.0, 7.0, 1.1};
    const SizeDistribution list = diameter_list(given);
    EXPECT_TRUE(std::ranges::is_permutation(draw_diameters(list, particle_count(list)), given));
}

TEST(DrawDiameters, SeedsAreReproducibleAndDiffer) {
    const PowerLaw law{10.0, 0.5};
    const auto first = draw_diameters(law, 1000, DrawMethod::random, 1);
    EXPECT_EQ(first, draw_diameters(law, 1000, DrawMethod::random, 1));
    EXPECT_NE(first, draw_diameters(law, 1000, DrawMethod::random, 2));
    EXPECT_EQ(draw_diameters(law, 1000, DrawMethod::stratified, 1),
              draw_diameters(law, 1000, DrawMethod::stratified, 2));
}

TEST(DrawDiameters, IsTheSameForAnyThreadCount) {
    const SizeDistribution sizes = GrainSizeDistribution{8.0, 0.5};
    const auto draw = [&] { return draw_diameters(sizes, 20000, DrawMethod::random, 5); };
    const auto alone = run_with_threads(1, draw);
    for (const int threads : {2, 3, 5}) EXPECT_EQ(run_with_threads(threads, draw), alone);
}

TEST(DrawDiameters, RefusesACountThatCannotBe) {
    EXPECT_THROW(draw_diameters(Monodisperse{}, 0), InputError);
}

}  // namespace
}  // namespace jam
