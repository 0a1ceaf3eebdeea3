// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/rod_packing.h"

#include "core/check.h"
#include "sizes/draw_diameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace jam {
namespace {

constexpr RodModel fewer_rods{.rod_count = 100'000};

TEST(RodPacking, OfEqualSpheresIsTheCalibration) {
    EXPECT_NEAR(rod_packing_fraction(Monodisperse{}), 0.6435, 1e-4);
    EXPECT_NEAR(rod_packing_fraction(Monodisperse{}, {.gap_factor = 0.780}), 0.639, 2e-4);
}

// Values of an independent implementation that drew its rods at random, good to +-2e-4.
TEST(RodPacking, OfPowerLaws) {
    constexpr double alphas[] = {0.2, 0.4, 0.55, 0.7, 1.0, 1.5};
    struct Row {
        double size_ratio;
        double fractions[6];
    };
    constexpr Row table[] = {{10, {0.7417, 0.7463, 0.7485, 0.7493, 0.7467, 0.7317}},
                             {20, {0.7802, 0.7890, 0.7929, 0.7937, 0.7832, 0.7471}},
                             {32, {0.8040, 0.8162, 0.8214, 0.8214, 0.7987, 0.7514}},
                             {50, {0.8247, 0.8402, 0.8466, 0.8428, 0.8080, 0.7535}},
                             {100, {0.8528, 0.8731, 0.8803, 0.8652, 0.8162, 0.7548}}};
    for (const Row& row : table)
        for (std::size_t i = 0; i < std::size(alphas); ++i)
            EXPECT_NEAR(rod_packing_fraction(PowerLaw{row.size_ratio, alphas[i]}, fewer_rods),
                        row.fractions[i], 5e-4)
                << "size ratio " << row.size_ratio << ", alpha " << alphas[i];
}

// The paper's own packings at lambda 50: 0.82, 0.85 and 0.80 (Monti et al., Fig. 3).
TEST(RodPacking, CalibratedToThePaperIsNearItsPackings) {
    const auto predicted = [](double alpha) {
        return rod_packing_fraction(PowerLaw{50.0, alpha},
                                    {.gap_factor = 0.780, .rod_count = 100'000});
    };
    EXPECT_NEAR(predicted(0.2), 0.82, 0.01);
    EXPECT_NEAR(predicted(0.55), 0.85, 0.01);
    EXPECT_NEAR(predicted(1.0), 0.80, 0.01);
}

TEST(RodPacking, OfLognormalsCutFarOut) {
    constexpr double sigmas[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0};
    constexpr double fractions[] = {0.6471, 0.6570, 0.6715, 0.6886, 0.7074, 0.7268, 0.7655, 0.8014};
    for (std::size_t i = 0; i < std::size(sigmas); ++i) {
        const Lognormal lognormal{sigmas[i], std::exp(16.0 * sigmas[i])};
        EXPECT_NEAR(rod_packing_fraction(lognormal, fewer_rods), fractions[i], 5e-4) << sigmas[i];
    }
}

TEST(RodPacking, DensestBinaryMixtures) {
    struct Peak {
        double size_ratio;
        double fraction;
    };
    for (const auto& [size_ratio, fraction] :
         {Peak{2, 0.682}, Peak{5, 0.787}, Peak{10, 0.827}, Peak{40, 0.852}, Peak{100, 0.857}}) {
        double densest = 0.0;
        for (double small = 0.19; small < 0.31; small += 0.01)
            densest =
                std::max(densest, rod_packing_fraction(Binary{size_ratio, small, 1}, fewer_rods));
        EXPECT_NEAR(densest, fraction, 1e-3) << "size ratio " << size_ratio;
    }
}

// Furnas (1931): at infinite ratio the small spheres either rattle in the holes of the large ones,
// phi = p / (1 - f_S), or hold them apart, phi = 1 / (f_S / p + 1 - f_S).
TEST(RodPacking, OfBinaryMixturesApproachesFurnas) {
    const double p = rod_packing_fraction(Monodisperse{});
    const auto at = [](double small) { return rod_packing_fraction(Binary{1000.0, small, 1}); };
    EXPECT_NEAR(at(0.1), p / 0.9, 0.005);
    EXPECT_NEAR(at(0.6), 1.0 / (0.6 / p + 0.4), 0.005);
    EXPECT_NEAR(at((1.0 - p) / (2.0 - p)), p + (1.0 - p) * p, 0.015);
}

TEST(RodPacking, OfDrawnDiametersAgreesWithTheirDistribution) {
    for (const SizeDistribution& sizes :
         {SizeDistribution{PowerLaw{10.0, 0.55}}, SizeDistribution{Binary{5.0, 0.25, 100}},
          SizeDistribution{GrainSizeDistribution{8.0, 0.5}}, SizeDistribution{Lognormal{0.4}}}) {
        auto diameters = draw_diameters(sizes, particle_count(sizes));
        std::ranges::reverse(diameters);
        EXPECT_NEAR(rod_packing_fraction(diameters, fewer_rods),
                    rod_packing_fraction(sizes, fewer_rods), 1e-3);
    }
}

TEST(RodPacking, DoesNotDependOnTheUnitOfLength) {
    const std::vector<double> small = {1.0, 1.5, 2.0, 4.0};
    const std::vector<double> large = {1000.0, 1500.0, 2000.0, 4000.0};
    EXPECT_NEAR(rod_packing_fraction(small, fewer_rods), rod_packing_fraction(large, fewer_rods),
                1e-12);
}

TEST(RodPacking, RefusesWhatItCannotPack) {
    EXPECT_THROW(rod_packing_fraction(std::span<const double>{}), InputError);
    EXPECT_THROW(rod_packing_fraction(std::vector<double>{1.0, 0.0}), InputError);
    EXPECT_THROW(rod_packing_fraction(Monodisperse{}, {.gap_factor = 0.0}), InputError);
    EXPECT_THROW(rod_packing_fraction(Monodisperse{}, {.rod_count = 0}), InputError);
}

}  // namespace
}  // namespace jam
