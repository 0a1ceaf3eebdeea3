// SPDX-License-Identifier: BSD-3-Clause
#include "grids/collection_choice.h"

#include "sizes/draw_diameters.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

constexpr InteractionReach reach{0.02, 0.1};

std::vector<double> power_law_diameters(double size_ratio, Count count) {
    std::vector<double> diameters;
    for (Count i = 0; i < count; ++i) {
        const double fraction = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        diameters.push_back(quantile(PowerLaw{size_ratio, 1.0}, Weight::number, fraction));
    }
    return diameters;
}

TEST(CollectionChoice, EqualSpheresTakeOneCollection) {
    EXPECT_EQ(cheapest_collections(std::vector<double>(1000, 2.5), reach).count(), 1);
}

TEST(CollectionChoice, TwoSizesFarApartTakeTwo) {
    std::vector<double> diameters(8000, 1.0);
    diameters.resize(8008, 20.0);
    EXPECT_EQ(cheapest_collections(diameters, reach).count(), 2);
}

TEST(CollectionChoice, NoGeometricOnesAreCheaperByTheModel) {
    const std::vector<double> diameters = power_law_diameters(30.0, 20000);
    const double chosen = search_cost(diameters, cheapest_collections(diameters, reach), reach);
    for (const double ratio : {1.6, 2.0, 3.0, 4.0, 6.0, 1000.0})
        EXPECT_LE(chosen, search_cost(diameters, geometric_collections(diameters, {.ratio = ratio}),
                                      reach));
}

TEST(CollectionChoice, OneGridCostsInProportionToTheNumberItMustTest) {
    const auto cost_of_one = [](double size_ratio) {
        const std::vector<double> diameters = power_law_diameters(size_ratio, 100000);
        return search_cost(diameters, collections_between(diameters, {}), reach);
    };
    EXPECT_GT(cost_of_one(50.0), 3.0 * cost_of_one(20.0));
}

}  // namespace
}  // namespace jam
