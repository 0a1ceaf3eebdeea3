// SPDX-License-Identifier: BSD-3-Clause
// Statistics of the contacts by number and by size.
#include "analysis/backbone_sizes.h"
#include "analysis/contact_numbers.h"
#include "analysis/contact_pair_sizes.h"
#include "analysis/coordination.h"
#include "analysis/size_coordination.h"
#include "core/check.h"
#include "core/random.h"
#include "support/packings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

using namespace test;
using testing::Each;
using testing::ElementsAre;

Contact contact_between(Index first, Index second) {
    return {first, second, Image::Zero(), 0.1, 0.1, Vec3::UnitX()};
}

Rattlers backbone_with(std::vector<std::uint8_t> is_rattler, std::vector<int> counts) {
    Rattlers rattlers;
    for (const std::uint8_t r : is_rattler) rattlers.rattler_count += r;
    rattlers.is_rattler = std::move(is_rattler);
    rattlers.contact_counts_nr = std::move(counts);
    return rattlers;
}

TEST(ContactNumbers, ByHand) {
    const ContactNumbers numbers =
        contact_numbers(backbone_with({0, 0, 1, 0, 0}, {4, 4, 0, 3, 12}));
    EXPECT_THAT(numbers.particle_counts, ElementsAre(0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 1));
    EXPECT_DOUBLE_EQ(numbers.share_of_particles(4, 4), 0.5);
    EXPECT_DOUBLE_EQ(numbers.share_of_particles(3, 10), 0.75);
    EXPECT_DOUBLE_EQ(numbers.share_of_contacts(3, 10), 11.0 / 23.0);
    EXPECT_THAT(table(numbers).columns[2].values[12], 0.25);
    EXPECT_EQ(contact_numbers(backbone_with({1, 1}, {0, 0})).share_of_particles(0, 10), 0.0);
}

TEST(ContactNumbers, SumToTheCoordinationOfTheBackbone) {
    const Packing packing = random_spheres(random_edges(15.0, 1), 600, 4.0, 1);
    const ForceNetwork network = find_force_network(packing);
    const ContactNumbers numbers = contact_numbers(network.rattlers);
    double sum = 0.0;
    for (int c = 0; c < 1000; ++c) sum += c * numbers.share_of_particles(c, c);
    ASSERT_GT(network.rattlers.rattler_count, 0);
    EXPECT_NEAR(sum, coordination_nr(network), 1e-12);
}

TEST(SizeCoordination, FindsTheLineThatWasPutIn) {
    // Contacts 3 + 40 (D / max D)^2, rounded; small particles are off the line on purpose.
    std::vector<double> diameters;
    std::vector<int> counts;
    for (int i = 0; i < 20000; ++i) {
        const double diameter = std::pow(10.0, i / 19999.0);
        diameters.push_back(diameter);
        const double area = diameter * diameter / 100.0;
        const double rounding = uniform(1, RandomStream::tests, static_cast<std::uint64_t>(i));
        const double wanted = area < 0.04 ? 9.0 : 3.0 + 40.0 * area;
        counts.push_back(static_cast<int>(std::floor(wanted + rounding)));
    }
    const Rattlers rattlers = backbone_with(std::vector<std::uint8_t>(20000, 0), counts);
    const SizeCoordination result = size_coordination(diameters, rattlers);
    EXPECT_NEAR(result.fit.slope, 40.0, 4.0 * result.fit.slope_error);
    EXPECT_NEAR(result.fit.intercept, 0.0, 4.0 * result.fit.intercept_error);
    EXPECT_LT(result.fit.slope_error, 0.5);
    EXPECT_NEAR(result.excess_contacts.front(), 6.0, 0.2);
    EXPECT_NEAR(result.excess_contacts.back(), 40.0 * result.scaled_areas.back(), 0.5);
}

TEST(SizeCoordination, LeavesRattlersOut) {
    const std::vector<double> diameters = {1.0, 1.0, 1.0, 10.0};
    const SizeCoordination result =
        size_coordination(diameters, backbone_with({0, 0, 1, 0}, {4, 6, 0, 20}));
    EXPECT_THAT(result.excess_contacts, ElementsAre(2.0, 17.0));
    EXPECT_THAT(result.particle_counts, ElementsAre(2, 1));
    EXPECT_THAT(result.diameters, ElementsAre(1.0, 10.0));
    EXPECT_NEAR(result.errors[0], 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(result.errors[1]));
    EXPECT_TRUE(std::isnan(result.fit.slope));
}

TEST(ContactPairSizes, ByHand) {
    // Four bins: 1, 10^(1/4), 10^(1/2), 10^(3/4), 10. Two contacts small-large, one small-small.
    const std::vector<double> diameters = {1.0, 1.1, 10.0, 9.0};
    const std::vector<Contact> contacts = {contact_between(0, 1), contact_between(0, 2),
                                           contact_between(1, 3)};
    const ContactPairSizes sizes = contact_pair_sizes(diameters, contacts, 4);
    ASSERT_EQ(sizes.bins.count(), 4);
    const double small = sizes.bins.width(0);
    const double large = sizes.bins.width(3);
    EXPECT_EQ(sizes.contact_counts(3, 0), 2);
    EXPECT_EQ(sizes.contact_counts(0, 3), 0);
    EXPECT_NEAR(sizes.joint(3, 0), 2.0 / 3.0 / (small * large), 1e-12);
    EXPECT_NEAR(sizes.joint(0, 0), 1.0 / 3.0 / (0.5 * small * small), 1e-12);
    EXPECT_NEAR(sizes.conditional(3, 0), sizes.joint(3, 0) / (0.5 / large), 1e-12);
    const auto [larger, smaller] = sizes.most_probable();
    EXPECT_NEAR(larger, std::pow(10.0, 1.0 / 8.0), 1e-12);
    EXPECT_NEAR(smaller, larger, 1e-12);
}

TEST(ContactPairSizes, IntegrateToOneOverTheTriangle) {
    const Packing packing = random_spheres(random_edges(12.0, 2), 500, 5.0, 2);
    const ContactPairSizes sizes =
        contact_pair_sizes(packing.diameters, find_contacts(packing), 10);
    double integral = 0.0;
    for (int a = 0; a < sizes.bins.count(); ++a)
        for (int b = 0; b <= a; ++b)
            integral += sizes.joint(a, b) * sizes.bins.width(a) * sizes.bins.width(b) *
                        (a == b ? 0.5 : 1.0);
    EXPECT_NEAR(integral, 1.0, 1e-12);
    const Table rows = table(sizes);
    EXPECT_EQ(rows.columns[0].values.size(),
              static_cast<std::size_t>(sizes.bins.count() * (sizes.bins.count() + 1) / 2));
}

TEST(BackboneSizes, ByHand) {
    const std::vector<double> diameters = {1.0, 2.0, 3.0, 4.0, 10.0};
    BackboneSizesSettings settings;
    settings.bins_per_decade = 1;
    settings.onset_threshold = 0.7;
    const BackboneSizes sizes =
        backbone_sizes(diameters, backbone_with({1, 0, 0, 0, 0}, {0, 3, 3, 3, 3}), settings);
    EXPECT_THAT(sizes.larger_nr, ElementsAre(1.0, 0.0));
    EXPECT_NEAR(sizes.density[0], 1.0 / 9.0, 1e-12);
    EXPECT_NEAR(sizes.density_nr[0], 1.0 / 9.0, 1e-12);
    // F is 1 below 2, 3/4 from 2, 1/2 from 3 on.
    EXPECT_NEAR(sizes.onset, 0.3, 1e-12);
    EXPECT_NEAR(sizes.effective_size_ratio, 10.0 / 3.0, 1e-12);
    settings.onset_threshold = 0.76;
    EXPECT_NEAR(
        backbone_sizes(diameters, backbone_with({1, 0, 0, 0, 0}, {0, 3, 3, 3, 3}), settings).onset,
        0.2, 1e-12);
}

TEST(BackboneSizes, PowerLawAboveAnOnset) {
    // All particles above D = 4 bear load, none below: F is that of the law cut off at 4.
    const double beta = 3.0;
    std::vector<double> diameters;
    std::vector<std::uint8_t> is_rattler;
    for (int i = 0; i < 100000; ++i) {
        const double u = (i + 0.5) / 100000;
        diameters.push_back(
            std::pow(1.0 + u * (std::pow(40.0, 1.0 - beta) - 1.0), 1.0 / (1.0 - beta)));
        is_rattler.push_back(diameters.back() < 4.0 ? 1 : 0);
    }
    const BackboneSizes sizes =
        backbone_sizes(diameters, backbone_with(is_rattler, std::vector<int>(100000, 4)));
    const auto power = [&](double d) { return std::pow(d, 1.0 - beta); };
    for (int b = 0; b <= sizes.bins.count(); ++b) {
        const double edge = std::max(4.0, sizes.bins.edges[b]);
        EXPECT_NEAR(sizes.larger_nr[b], (power(edge) - power(40.0)) / (power(4.0) - power(40.0)),
                    2e-3);
    }
    const double expected =
        std::pow(power(4.0) - 0.01 * (power(4.0) - power(40.0)), -0.5) / diameters.back();
    EXPECT_NEAR(sizes.onset, expected, 1e-3 * expected);
}

TEST(BackboneSizes, NoBackboneNoOnset) {
    const std::vector<double> diameters = {1.0, 2.0};
    const BackboneSizes sizes = backbone_sizes(diameters, backbone_with({1, 1}, {0, 0}));
    EXPECT_TRUE(std::isnan(sizes.onset));
    EXPECT_THAT(sizes.density_nr, Each(0.0));
    BackboneSizesSettings settings;
    settings.onset_threshold = 1.0;
    EXPECT_THROW(backbone_sizes(diameters, backbone_with({0, 0}, {3, 3}), settings), InputError);
}

}  // namespace
}  // namespace jam
