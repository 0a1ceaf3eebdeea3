// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/significance.h"

#include "analysis/bootstrap.h"
#include "analysis/compare_packings.h"
#include "core/check.h"
#include "support/packings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

using namespace test;

std::vector<double> uniforms(std::uint64_t seed, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(uniform(seed, RandomStream::tests, static_cast<std::uint64_t>(i)));
    return values;
}

TEST(Bootstrap, ErrorOfAMeanIsThatOfTheTextbook) {
    const std::vector<double> values = uniforms(1, 20);
    double mean = 0.0;
    for (const double value : values) mean += value / 20.0;
    double variance = 0.0;
    for (const double value : values) variance += (value - mean) * (value - mean) / 19.0;
    BootstrapSettings settings;
    settings.resamples = 20000;
    const Estimate estimate = bootstrap_mean(values, settings);
    EXPECT_NEAR(estimate.value, mean, 1e-14);
    EXPECT_NEAR(estimate.error / std::sqrt(variance / 20.0), 1.0, 0.03);
    EXPECT_NEAR((estimate.high - estimate.low) / (2.0 * 1.96 * estimate.error), 1.0, 0.06);
    EXPECT_EQ(estimate.count, 20);
}

TEST(Bootstrap, AnyStatistic) {
    // The largest of n: resamples miss it with probability (1 - 1/n)^n.
    const std::vector<double> values = uniforms(2, 10);
    const auto largest = [&](std::span<const Index> chosen) {
        double result = 0.0;
        for (const Index i : chosen) result = std::max(result, values[i]);
        return result;
    };
    const Estimate estimate = bootstrap(10, largest);
    EXPECT_EQ(estimate.value, *std::max_element(values.begin(), values.end()));
    EXPECT_EQ(estimate.high, estimate.value);
    EXPECT_LT(estimate.low, estimate.value);
}

TEST(Bootstrap, TheSameSeedTheSameErrorForAnyThreadCount) {
    const std::vector<double> values = uniforms(3, 7);
    const auto measure = [&] { return bootstrap_mean(values).error; };
    const double reference = run_with_threads(1, measure);
    EXPECT_EQ(run_with_threads(3, measure), reference);
    BootstrapSettings other;
    other.seed = 2;
    EXPECT_NE(bootstrap_mean(values, other).error, reference);
}

TEST(Bootstrap, OneValueHasNoError) {
    const Estimate estimate = bootstrap_mean(std::vector<double>{0.64});
    EXPECT_EQ(estimate.value, 0.64);
    EXPECT_TRUE(std::isnan(estimate.error));
}

TEST(MeanDifference, AgainstStudentsTable) {
    // Equal samples of two with variances 2: t = d / sqrt(2) with 2 degrees of freedom;
    // t = 4.302653 is the two-sided 5 % point.
    const double d = 4.302652729911275 * std::sqrt(2.0);
    const std::vector<double> a = {-1.0, 1.0};
    const std::vector<double> b = {d - 1.0, d + 1.0};
    EXPECT_NEAR(mean_difference_p_value(a, b), 0.05, 1e-9);
    EXPECT_NEAR(mean_difference_p_value(b, a), 0.05, 1e-9);
    EXPECT_NEAR(mean_difference_p_value(a, a), 1.0, 1e-12);
    // One value against three of variance 1: t = d / sqrt(4/3), two degrees of freedom.
    const std::vector<double> several = {-1.0, 0.0, 1.0};
    const std::vector<double> one = {4.302652729911275 * std::sqrt(4.0 / 3.0)};
    EXPECT_NEAR(mean_difference_p_value(one, several), 0.05, 1e-9);
    EXPECT_NEAR(mean_difference_p_value(several, one), 0.05, 1e-9);
}

TEST(MeanDifference, WithoutScatter) {
    const std::vector<double> one = {1.0};
    const std::vector<double> two = {2.0};
    EXPECT_TRUE(std::isnan(mean_difference_p_value(one, two)));
    const std::vector<double> ones = {1.0, 1.0};
    const std::vector<double> twos = {2.0, 2.0};
    EXPECT_EQ(mean_difference_p_value(ones, twos), 0.0);
    EXPECT_EQ(mean_difference_p_value(ones, ones), 1.0);
}

TEST(DistributionDifference, ByHand) {
    EXPECT_DOUBLE_EQ(distribution_difference({1.0, 2.0, 3.0, 4.0}, {2.5, 3.5}).distance, 0.5);
    EXPECT_DOUBLE_EQ(distribution_difference({1.0, 1.0, 2.0}, {1.0, 1.0, 2.0}).distance, 0.0);
    EXPECT_DOUBLE_EQ(distribution_difference({1.0}, {2.0}).distance, 1.0);
    // Kolmogorov's distribution: 1.3581 is its 5 % point.
    const auto ladder = [](int count, double from) {
        std::vector<double> values;
        for (int i = 0; i < count; ++i) values.push_back(from + (i + 0.5) / count);
        return values;
    };
    const double root = std::sqrt(50000.0);
    const double shift = 1.3581015 / (root + 0.12 + 0.11 / root);
    const auto difference = distribution_difference(ladder(100000, 0.0), ladder(100000, shift));
    EXPECT_NEAR(difference.distance, shift, 1.1e-5);
    EXPECT_NEAR(difference.p_value, 0.05, 0.002);
}

TEST(DistributionDifference, IsUniformWhenThereIsNone) {
    int below = 0;
    constexpr int trials = 500;
    for (int trial = 0; trial < trials; ++trial) {
        const auto seed = static_cast<std::uint64_t>(2 * trial);
        if (distribution_difference(uniforms(seed, 200), uniforms(seed + 1, 300)).p_value < 0.2)
            ++below;
    }
    EXPECT_NEAR(below / double(trials), 0.2, 4.0 * std::sqrt(0.2 * 0.8 / trials));
}

PackingSummary summary_of(const Packing& packing) {
    return summarize(packing, find_force_network(packing));
}

const NumberComparison& number_named(const PackingComparison& comparison, const char* name) {
    for (const NumberComparison& number : comparison.numbers)
        if (number.name == name) return number;
    throw std::runtime_error(name);
}

TEST(ComparePackings, SeesWhatDiffersAndOnlyThat) {
    std::vector<PackingSummary> sparse, dense, again;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Mat3 edges = Mat3::Identity() * 10.0;
        sparse.push_back(summary_of(random_spheres(edges, 600, 2.0, seed)));
        again.push_back(summary_of(random_spheres(edges, 600, 2.0, seed + 100)));
        dense.push_back(summary_of(random_spheres(edges, 800, 2.0, seed + 200)));
    }
    const PackingComparison different = compare_packings(sparse, dense);
    const PackingComparison alike = compare_packings(sparse, again);
    EXPECT_LT(number_named(different, "coordination").p_value, 1e-3);
    EXPECT_GT(number_named(alike, "coordination").p_value, 1e-3);
    EXPECT_NEAR(number_named(different, "particle_count").difference, 200.0, 1e-12);
    ASSERT_EQ(different.distributions.size(), 5u);
    EXPECT_LT(different.distributions[1].difference.p_value, 1e-6);
    EXPECT_GT(alike.distributions[0].difference.p_value, 1e-4);
}

TEST(ComparePackings, SeesThatOtherSizesTouch) {
    // The same spheres and as many contacts: pairs of equal ones, or each with one of another size.
    const auto pairs = [](double first, double second) {
        std::vector<Vec3> centers;
        std::vector<double> diameters;
        const auto add = [&](int pair, double one, double other) {
            const double x = 10.0 * pair;
            centers.insert(centers.end(), {Vec3(x, 0, 0), Vec3(x + 0.49 * (one + other), 0, 0)});
            diameters.insert(diameters.end(), {one, other});
        };
        for (int pair = 0; pair < 20; ++pair)
            pair % 2 == 0 ? add(pair, 1.0, first) : add(pair, 2.0, second);
        Packing packing = make_packing(Mat3::Identity() * 200.0, centers, diameters);
        ForceNetwork network = find_force_network(packing);
        network.rattlers.is_rattler.assign(packing.diameters.size(), 0);
        return summarize(packing, network);
    };
    const std::vector<PackingSummary> alike = {pairs(1.0, 2.0)};
    const std::vector<PackingSummary> mixed = {pairs(2.0, 1.0)};
    const PackingComparison comparison = compare_packings(alike, mixed);
    EXPECT_EQ(comparison.distributions[0].difference.distance, 0.0);
    EXPECT_DOUBLE_EQ(comparison.distributions[3].difference.distance, 0.5);
    EXPECT_DOUBLE_EQ(comparison.distributions[4].difference.distance, 1.0);
}

TEST(ComparePackings, OneAgainstOneHasNoScatterButDistributions) {
    const Mat3 edges = Mat3::Identity() * 10.0;
    const std::vector<PackingSummary> a = {summary_of(random_spheres(edges, 600, 2.0, 1))};
    const std::vector<PackingSummary> b = {summary_of(random_spheres(edges, 800, 2.0, 2))};
    const PackingComparison comparison = compare_packings(a, b);
    EXPECT_TRUE(std::isnan(number_named(comparison, "coordination").p_value));
    EXPECT_LT(comparison.distributions[1].difference.p_value, 1e-3);
    EXPECT_THROW(compare_packings(a, {}), InputError);
}

TEST(Summarize, IsWhatTheNetworkHolds) {
    const Packing packing = random_spheres(random_edges(15.0, 1), 600, 4.0, 1);
    const ForceNetwork network = find_force_network(packing);
    const PackingSummary summary = summarize(packing, network);
    EXPECT_EQ(static_cast<Count>(summary.backbone_diameters.size()),
              network.rattlers.backbone_count());
    EXPECT_EQ(static_cast<Count>(summary.backbone_forces.size()),
              network.rattlers.contact_count_nr);
    double mean = 0.0;
    for (const double force : summary.backbone_forces)
        mean += force / static_cast<double>(summary.backbone_forces.size());
    EXPECT_NEAR(mean, 1.0, 1e-12);
    double contacts = 0.0;
    for (const double count : summary.backbone_contact_counts) contacts += count;
    EXPECT_EQ(contacts, 2.0 * static_cast<double>(network.rattlers.contact_count_nr));
}

}  // namespace
}  // namespace jam
