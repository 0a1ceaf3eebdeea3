// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/linear_fit.h"
#include "analysis/measured_sizes.h"
#include "analysis/power_law_fit.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace jam {
namespace {

/// Values of density ~ x^exponent on [low, high] at stratified quantiles.
std::vector<double> power_law_values(double exponent, double low, double high, int count) {
    std::vector<double> values;
    const double p = exponent + 1.0;
    for (int i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count;
        values.push_back(
            std::abs(p) < 1e-12
                ? low * std::pow(high / low, u)
                : std::pow(std::pow(low, p) + u * (std::pow(high, p) - std::pow(low, p)), 1.0 / p));
    }
    return values;
}

TEST(FitPowerLaw, FindsTheExponent) {
    for (const double exponent : {-3.45, -1.0, 0.0, 0.42, 2.0}) {
        const auto values = power_law_values(exponent, 0.5, 20.0, 20000);
        const PowerLawFit fit = fit_power_law(values, 0.5, 20.0);
        EXPECT_NEAR(fit.exponent, exponent, 2e-3) << exponent;
        EXPECT_EQ(fit.value_count, 20000);
    }
}

TEST(FitPowerLaw, LooksOnlyInItsWindow) {
    auto values = power_law_values(0.42, 1e-3, 0.1, 20000);
    values.insert(values.end(), 50000, 0.5);
    values.insert(values.end(), 50000, 1e-4);
    const PowerLawFit fit = fit_power_law(values, 1e-3, 0.1);
    EXPECT_EQ(fit.value_count, 20000);
    EXPECT_NEAR(fit.exponent, 0.42, 2e-3);
}

TEST(FitPowerLaw, ErrorIsTheScatterOverSamples) {
    constexpr int samples = 400;
    constexpr int size = 300;
    double sum = 0.0;
    double squares = 0.0;
    double error = 0.0;
    for (int sample = 0; sample < samples; ++sample) {
        std::vector<double> values;
        for (int i = 0; i < size; ++i) {
            const double u = uniform(static_cast<std::uint64_t>(sample), RandomStream::tests,
                                     static_cast<std::uint64_t>(i));
            values.push_back(std::pow(1.0 + u * (std::pow(10.0, -1.5) - 1.0), 1.0 / -1.5));
        }
        const PowerLawFit fit = fit_power_law(values, 1.0, 10.0);
        sum += fit.exponent;
        squares += fit.exponent * fit.exponent;
        error = fit.error;
    }
    const double mean = sum / samples;
    EXPECT_NEAR(mean, -2.5, 0.02);
    EXPECT_NEAR(std::sqrt(squares / samples - mean * mean) / error, 1.0, 0.15);
}

TEST(FitPowerLaw, NothingToFit) {
    EXPECT_TRUE(std::isnan(fit_power_law(std::vector<double>{5.0}, 1.0, 2.0).exponent));
    EXPECT_TRUE(std::isnan(fit_power_law(std::vector<double>{1.0, 1.0}, 1.0, 1.0).exponent));
}

TEST(FitLine, ExactLineWhateverTheErrors) {
    const std::vector<double> x = {1.0, 2.0, 4.0, 8.0};
    const std::vector<double> y = {5.0, 7.0, 11.0, 19.0};
    const std::vector<double> errors = {0.1, 1.0, 0.3, 0.2};
    const LinearFit fit = fit_line(x, y, errors);
    EXPECT_NEAR(fit.intercept, 3.0, 1e-12);
    EXPECT_NEAR(fit.slope, 2.0, 1e-12);
    EXPECT_NEAR(fit.reduced_chi_squared, 0.0, 1e-20);
    EXPECT_EQ(fit.point_count, 4);
}

TEST(FitLine, ErrorsByHand) {
    // Points (-1, 0), (0, 0), (1, 3) of error 1: slope 3/2, intercept 1; residuals 1/2, -1, 1/2.
    const std::vector<double> x = {-1.0, 0.0, 1.0};
    const std::vector<double> y = {0.0, 0.0, 3.0};
    const std::vector<double> errors = {1.0, 1.0, 1.0};
    const LinearFit fit = fit_line(x, y, errors);
    EXPECT_NEAR(fit.slope, 1.5, 1e-12);
    EXPECT_NEAR(fit.intercept, 1.0, 1e-12);
    EXPECT_NEAR(fit.reduced_chi_squared, 1.5, 1e-12);
    EXPECT_NEAR(fit.slope_error, std::sqrt(1.5 / 2.0), 1e-12);
    EXPECT_NEAR(fit.intercept_error, std::sqrt(1.5 / 3.0), 1e-12);
    const std::vector<double> wide = {10.0, 10.0, 10.0};
    EXPECT_NEAR(fit_line(x, y, wide).slope_error, 10.0 / std::numbers::sqrt2, 1e-12);
}

TEST(FitLine, PointsThatDetermineNoLine) {
    const std::vector<double> same = {1.0, 1.0};
    const std::vector<double> errors = {1.0, 1.0};
    EXPECT_TRUE(std::isnan(fit_line(same, errors, errors).slope));
    EXPECT_TRUE(std::isnan(fit_line({}, {}, {}).slope));
}

TEST(MeasuredSizes, PowerLawGivesItsOwnAlphaAndCurve) {
    const double alpha = 0.55;
    const double size_ratio = 10.0;
    const auto diameters = power_law_values(alpha - 4.0, 1.0, size_ratio, 200000);
    const SizePowerLaw law = fit_sizes(diameters);
    EXPECT_NEAR(law.alpha, alpha, 0.01);
    EXPECT_NEAR(law.beta, 4.0 - alpha, 0.01);
    EXPECT_NEAR(law.fractal_dimension, 3.0 - alpha, 0.01);
    const CumulativeVolume volume = cumulative_volume(diameters);
    for (std::size_t k = 0; k < volume.diameters.size(); ++k) {
        const double analytic =
            (std::pow(volume.diameters[k], alpha) - 1.0) / (std::pow(size_ratio, alpha) - 1.0);
        EXPECT_NEAR(volume.fractions[k], analytic, 2e-3);
        EXPECT_NEAR(volume.reduced[k], (volume.diameters[k] - 1.0) / 9.0, 1e-3);
    }
    EXPECT_EQ(volume.fractions.back(), 1.0);
}

TEST(MeasuredSizes, OneSize) {
    const std::vector<double> diameters(10, 2.0);
    const CumulativeVolume volume = cumulative_volume(diameters);
    EXPECT_EQ(volume.fractions, std::vector<double>{1.0});
    EXPECT_EQ(volume.reduced, std::vector<double>{0.0});
    EXPECT_TRUE(std::isnan(fit_sizes(diameters).alpha));
}

}  // namespace
}  // namespace jam
