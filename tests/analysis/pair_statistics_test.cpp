// SPDX-License-Identifier: BSD-3-Clause
// Statistics of pairs by their force and their distance.
#include "analysis/force_distribution.h"
#include "analysis/gap_distribution.h"
#include "analysis/radial_distribution.h"
#include "core/check.h"
#include "core/parallel.h"
#include "neighbors/brute_force_neighbors.h"
#include "support/packings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace jam {
namespace {

using namespace test;
using std::numbers::pi;
using testing::Each;

Count sum(const std::vector<Count>& counts) {
    return std::accumulate(counts.begin(), counts.end(), Count{0});
}

/// A network of pairs that pull against each other twice over, so that all forces balance.
ForceNetwork network_of_forces(const std::vector<double>& forces) {
    ForceNetwork network;
    for (std::size_t c = 0; c < forces.size(); ++c) {
        const auto i = static_cast<Index>(2 * c);
        for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX())})
            network.contacts.push_back({i, i + 1, Image::Zero(), forces[c], forces[c], normal});
    }
    const auto count = static_cast<Index>(2 * forces.size());
    network.rows = contact_rows(count, network.contacts);
    network.rattlers = find_rattlers(network.contacts, network.rows, 1);
    return network;
}

TEST(ForceDistribution, FindsTheExponentOfSmallForces) {
    // P(f) ~ f^0.42 on [0, 1].
    std::vector<double> forces;
    for (int i = 0; i < 50000; ++i) forces.push_back(std::pow((i + 0.5) / 50000, 1.0 / 1.42));
    const ForceDistribution result = force_distribution(network_of_forces(forces));
    EXPECT_NEAR(result.mean_force, 1.42 / 2.42, 1e-4);
    EXPECT_NEAR(result.small_forces.exponent, 0.42, 0.02);
    EXPECT_EQ(result.small_forces.high, 0.1);
    double integral = 0.0;
    for (int b = 0; b < result.bins.count(); ++b)
        integral += result.density[b] * result.bins.width(b);
    EXPECT_NEAR(integral, 1.0, 1e-12);
    EXPECT_EQ(sum(result.contact_counts), 100000);
}

TEST(ForceDistribution, LeavesRattlersOut) {
    ForceNetwork network = network_of_forces({1.0, 2.0, 6.0});
    network.rattlers.is_rattler[4] = 1;
    const ForceDistribution result = force_distribution(network);
    EXPECT_DOUBLE_EQ(result.mean_force, 1.5);
    EXPECT_EQ(sum(result.contact_counts), 4);
}

TEST(ForceDistribution, NoContacts) {
    const ForceDistribution result = force_distribution(network_of_forces({}));
    EXPECT_EQ(result.bins.count(), 1);
    EXPECT_TRUE(std::isnan(result.small_forces.exponent));
}

/// Everything in the backbone, whatever touches.
ForceNetwork all_backbone(const Packing& packing) {
    ForceNetwork network;
    network.rows = contact_rows(static_cast<Index>(packing.size()), {});
    network.rattlers.is_rattler.assign(packing.positions.size(), 0);
    return network;
}

TEST(GapDistribution, TwoSpheresByHand) {
    // Diameters 1 and 2 with centers 1.53 apart: gap 0.02.
    const Packing packing =
        make_packing(Mat3::Identity() * 9.0, {{1.0, 1.0, 1.0}, {1.0, 2.53, 1.0}}, {1.0, 2.0});
    ForceNetwork network = all_backbone(packing);
    const GapDistribution result = gap_distribution(packing, network);
    const int bin = result.bins.bin_of(0.02);
    EXPECT_EQ(result.pair_counts[bin], 1);
    EXPECT_EQ(sum(result.pair_counts), 1);
    EXPECT_NEAR(result.density[bin], 1.0 / result.bins.width(bin), 1e-9);
    network.rattlers.is_rattler[0] = 1;
    EXPECT_EQ(sum(gap_distribution(packing, network).pair_counts), 0);
}

TEST(GapDistribution, OfPointsWithoutOrder) {
    // Spheres of diameter 1 at random: dn/dh = N / V 4 pi (1 + h)^2 a particle.
    const Packing packing = random_spheres(Mat3::Identity() * 12.0, 8000, 1.0, 5);
    const GapDistribution result = gap_distribution(packing, all_backbone(packing));
    const double number_density = 8000.0 / packing.cell.volume();
    for (int b = 0; b < result.bins.count(); ++b) {
        if (result.pair_counts[b] < 1000) continue;
        const double middle = 0.5 * (result.bins.edges[b] + result.bins.edges[b + 1]);
        const double expected = number_density * 4.0 * pi * (1.0 + middle) * (1.0 + middle);
        const double error = expected / std::sqrt(static_cast<double>(result.pair_counts[b]));
        EXPECT_NEAR(result.density[b], expected, 4.0 * error);
    }
    EXPECT_GT(sum(result.pair_counts), 20000);
    EXPECT_NEAR(result.small_gaps.exponent, 0.0, 0.1);
}

TEST(GapDistribution, WithinWhatASmallCellAllows) {
    Packing packing = random_spheres(Mat3::Identity() * 1.05, 3, 1.0, 6);
    const GapDistribution result = gap_distribution(packing, all_backbone(packing));
    EXPECT_NEAR(result.bins.edges.back(), 0.05, 1e-6);
}

TEST(RadialDistribution, OfPointsWithoutOrder) {
    const Packing packing = random_spheres(random_edges(14.0, 7), 6000, 4.0, 7);
    RadialDistributionSettings settings;
    settings.bins = 10;
    const RadialDistribution result = radial_distribution(packing, settings);
    ASSERT_EQ(result.pairs.size(), 6u);
    EXPECT_EQ(sum(result.class_sizes), 6000);
    for (const RadialDistribution::Pair& pair : result.pairs) {
        EXPECT_LE(pair.class_1, pair.class_2);
        for (std::size_t b = 0; b < pair.values.size(); ++b) {
            if (pair.counts[b] < 100) continue;
            EXPECT_NEAR(pair.values[b], 1.0, 5.0 / std::sqrt(static_cast<double>(pair.counts[b])));
        }
    }
    EXPECT_GT(sum(result.pairs[5].counts), 100000);
}

TEST(RadialDistribution, ShellsOfACrystal) {
    const Packing packing = face_centered_cubic(4, 1.0, 1.0 / std::numbers::sqrt2);
    RadialDistributionSettings settings;
    settings.bins = 100;
    settings.largest = 2.1;
    const RadialDistribution result = radial_distribution(packing, settings);
    ASSERT_EQ(result.pairs.size(), 1u);
    const auto count_near = [&](double x) {  // round-off may put a shell on either side of an edge
        const int bin = result.bins.bin_of(x);
        const auto& counts = result.pairs[0].counts;
        return counts[bin - 1] + counts[bin] + counts[bin + 1];
    };
    EXPECT_EQ(count_near(1.0), 256 * 12 / 2);
    EXPECT_EQ(count_near(std::sqrt(2.0)), 256 * 6 / 2);
    EXPECT_EQ(count_near(std::sqrt(3.0)), 256 * 24 / 2);
    EXPECT_EQ(count_near(2.0), 256 * 12 / 2);
    EXPECT_EQ(sum(result.pairs[0].counts), 256 * 54 / 2);
}

TEST(RadialDistribution, CountsAsBruteForceDoes) {
    const Packing packing = random_spheres(random_edges(9.0, 8), 300, 4.0, 8);
    const RadialDistribution result = radial_distribution(packing);
    const double largest = result.bins.edges.back();
    const WrappedSpheres wrapped = wrap_spheres(packing);
    Count expected = 0;
    for (const NearPair& pair : brute_force_neighbors(wrapped.cell, wrapped.spheres, largest - 1.0))
        expected += pair.first == pair.second ? 0 : 1;
    Count found = 0;
    for (const RadialDistribution::Pair& pair : result.pairs) found += sum(pair.counts);
    EXPECT_EQ(found, expected);
}

TEST(RadialDistribution, TheSameForAnyThreadCount) {
    const Packing packing = random_spheres(random_edges(14.0, 9), 3000, 4.0, 9);
    const auto measure = [&] { return radial_distribution(packing).pairs[2].counts; };
    const std::vector<Count> reference = run_with_threads(1, measure);
    for (const int threads : {2, 5}) EXPECT_EQ(run_with_threads(threads, measure), reference);
}

TEST(RadialDistribution, RefusesWhatMeansNothing) {
    const Packing packing = simple_cubic(3, 1.0, 1.0);
    RadialDistributionSettings settings;
    settings.size_classes = 0;
    EXPECT_THROW(radial_distribution(packing, settings), InputError);
    settings.size_classes = 2;
    settings.largest = 1.0;
    EXPECT_THROW(radial_distribution(packing, settings), InputError);
}

}  // namespace
}  // namespace jam
