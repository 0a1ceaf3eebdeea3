// SPDX-License-Identifier: BSD-3-Clause
#include "report/packing_groups.h"

#include "sizes/draw_diameters.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

/// Only what names and averages look at.
Measurements with(std::vector<double> diameters, double volume_fraction = 0.0) {
    Measurements m;
    const auto [low, high] = std::ranges::minmax(diameters);
    m.statistics.size_ratio = high / low;
    m.statistics.volume_fraction = volume_fraction;
    m.cumulative_volume = cumulative_volume(diameters);
    m.power_law = fit_sizes(diameters);
    return m;
}

TEST(PackingGroups, SizesAreRecognisedFromDiameters) {
    for (const PowerLaw& law : {PowerLaw{5.0, 0.55}, {10.0, 1.0}, {20.0, 0.3}, {2.5, 0.8}}) {
        const SizesName name = name_of(with(draw_diameters(law, particle_count(law))));
        ASSERT_TRUE(name.law.has_value()) << law.size_ratio;
        EXPECT_EQ(name.law->size_ratio, law.size_ratio);
        EXPECT_NEAR(name.law->alpha, law.alpha, 1e-12);
        EXPECT_EQ(name.words, name_of(SizeDistribution{law}).words);
    }
}

TEST(PackingGroups, OtherSizesAreNotTakenForAPowerLaw) {
    EXPECT_EQ(name_of(with({1.0, 1.0, 1.0})).words, "equal spheres");
    const Binary binary{5.0, 0.25, 50};
    const SizesName name = name_of(with(draw_diameters(binary, particle_count(binary))));
    EXPECT_FALSE(name.law.has_value());
}

TEST(PackingGroups, MeansAndErrorsOverSeeds) {
    std::vector<NamedMeasurements> packings;
    const auto add = [&](const PowerLaw& law, double volume_fraction) {
        packings.push_back(
            {"p", name_of(SizeDistribution{law}), with(draw_diameters(law, 200), volume_fraction)});
    };
    add({10.0, 0.5}, 0.71);
    add({5.0, 0.8}, 0.69);
    add({10.0, 0.5}, 0.73);
    add({10.0, 0.5}, 0.72);
    const std::vector<PackingGroup> groups = group_packings(packings);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].sizes.law->size_ratio, 5.0);  // small size ratios first
    EXPECT_EQ(groups[0].members, (std::vector<int>{1}));
    EXPECT_TRUE(std::isnan(groups[0].volume_fraction.error));
    EXPECT_EQ(groups[1].members, (std::vector<int>{0, 2, 3}));
    EXPECT_NEAR(groups[1].volume_fraction.value, 0.72, 1e-12);
    EXPECT_NEAR(groups[1].volume_fraction.error, 0.01 / std::sqrt(3.0), 5e-4);
}

TEST(PackingGroups, ARowAGroup) {
    const PowerLaw law{5.0, 0.8};
    const std::vector<NamedMeasurements> packings = {
        {"a", name_of(SizeDistribution{law}), with(draw_diameters(law, 200), 0.7)},
        {"b", name_of(SizeDistribution{Monodisperse{}}), with({1.0, 1.0}, 0.64)}};
    const Table table = groups_table(group_packings(packings));
    EXPECT_EQ(table.columns[0].name, "size_ratio");
    EXPECT_EQ(table.columns[0].values, (std::vector<double>{5.0}));
    EXPECT_EQ(table.columns[1].values, (std::vector<double>{0.8}));
    EXPECT_EQ(table.columns[3].name, "volume_fraction");
    EXPECT_EQ(table.columns[3].values, (std::vector<double>{0.7}));
}

}  // namespace
}  // namespace jam
