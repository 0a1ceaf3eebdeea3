// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/size_distribution.h"

#include "sizes/size_table.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace jam {
namespace {

// Of the quadratures below: for eta = 1/2, 1e-7 of the particles differ from D = 1 by less than a
// double can tell, and the density is infinite there.
constexpr double tolerance = 1e-6;

struct Case {
    std::string name;
    SizeDistribution sizes;
};

std::vector<Case> continuous_cases() {
    std::vector<Case> cases;
    for (const double alpha : {-0.5, 0.0, 0.2, 0.55, 1.0, 2.0, 3.0, 3.3, 4.0})
        for (const double size_ratio : {1.1, 50.0, 1000.0})
            cases.push_back({"alpha " + std::to_string(alpha), PowerLaw{size_ratio, alpha}});
    for (const double eta : {0.5, 0.8, 1.0, 1.9})
        for (const double size_ratio : {1.1, 32.0, 1000.0})
            cases.push_back({"eta " + std::to_string(eta), GrainSizeDistribution{size_ratio, eta}});
    for (const double sigma : {0.1, 0.6, 1.0})
        cases.push_back({"sigma " + std::to_string(sigma), Lognormal{sigma}});
    cases.push_back({"narrow lognormal", Lognormal{0.5, 1.2}});
    const std::vector<double> diameters = {0.5, 1.0, 1.5, 4.0, 10.0};
    const std::vector<double> fractions = {0.0, 0.1, 0.1, 0.6, 1.0};
    for (const Weight given : {Weight::number, Weight::volume})
        cases.push_back({given == Weight::number ? "number curve" : "volume curve",
                         cumulative_curve(diameters, fractions, given)});
    return cases;
}

std::vector<Case> discrete_cases() {
    return {{"binary", Binary{4.0, 0.3, 10}},
            {"equal", Monodisperse{}},
            {"list", diameter_list({3.0, 1.0, 2.0, 2.0, 5.0})}};
}

// Integral of D^order n(D) from the smallest diameter to `end`, by quadrature of the density over
// ln D, piece by piece so that the corners of curves fall between pieces.
double integrate_density(const SizeDistribution& sizes, double order, double end) {
    std::vector<double> corners = {smallest_diameter(sizes), end};
    if (const auto* curve = std::get_if<CumulativeCurve>(&sizes)) {
        corners = {smallest_diameter(sizes)};
        for (const double corner : curve->diameters)
            if (corner > corners.back() && corner < end) corners.push_back(corner);
        corners.push_back(end);
    }
    boost::math::quadrature::tanh_sinh<double> quadrature;
    double sum = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const double from = corners[i - 1];
        const double to = corners[i];
        sum += quadrature.integrate(
            [&](double x) {
                const double diameter = std::exp(x);
                if (!(diameter > from && diameter < to)) return 0.0;
                return std::pow(diameter, order + 1.0) * number_density(sizes, diameter);
            },
            std::log(from), std::log(to));
    }
    return sum;
}

TEST(SizeDistribution, DensityIsNormalised) {
    for (const auto& [name, sizes] : continuous_cases())
        EXPECT_NEAR(integrate_density(sizes, 0.0, largest_diameter(sizes)), 1.0, tolerance) << name;
}

TEST(SizeDistribution, MomentsAreTheIntegralsOfTheDensity) {
    for (const auto& [name, sizes] : continuous_cases())
        for (const double order : {-1.0, 1.0, 2.0, 3.0, 6.0}) {
            const double integral = integrate_density(sizes, order, largest_diameter(sizes));
            EXPECT_NEAR(moment(sizes, order) / integral, 1.0, tolerance)
                << name << ", order " << order;
        }
}

TEST(SizeDistribution, CumulativeFractionsAreTheIntegralsOfTheDensity) {
    for (const auto& [name, sizes] : continuous_cases()) {
        const double smallest = smallest_diameter(sizes);
        const double largest = largest_diameter(sizes);
        const double all_volume = integrate_density(sizes, 3.0, largest);
        for (const double along : {0.1, 0.3, 0.5, 0.8, 0.99}) {
            const double diameter = smallest * std::pow(largest / smallest, along);
            EXPECT_NEAR(cumulative_fraction(sizes, Weight::number, diameter),
                        integrate_density(sizes, 0.0, diameter), tolerance)
                << name << " at " << diameter;
            EXPECT_NEAR(cumulative_fraction(sizes, Weight::volume, diameter),
                        integrate_density(sizes, 3.0, diameter) / all_volume, tolerance)
                << name << " at " << diameter;
        }
    }
}

TEST(SizeDistribution, QuantilesInvertCumulativeFractions) {
    for (const auto& [name, sizes] : continuous_cases())
        for (const Weight weight : {Weight::number, Weight::volume}) {
            double before = smallest_diameter(sizes);
            for (const double fraction : {0.01, 0.11, 0.3, 0.5, 0.77, 0.95, 0.999, 0.9999999}) {
                const double diameter = quantile(sizes, weight, fraction);
                EXPECT_NEAR(cumulative_fraction(sizes, weight, diameter), fraction, 1e-9) << name;
                EXPECT_GE(diameter, before) << name;
                before = diameter;
            }
            EXPECT_DOUBLE_EQ(quantile(sizes, weight, 0.0), smallest_diameter(sizes)) << name;
            EXPECT_NEAR(quantile(sizes, weight, 1.0) / largest_diameter(sizes), 1.0, 1e-9) << name;
        }
}

TEST(SizeDistribution, DiscreteQuantilesAreTheSmallestDiametersThatReachTheFraction) {
    for (const auto& [name, sizes] : discrete_cases())
        for (const Weight weight : {Weight::number, Weight::volume})
            for (int i = 0; i <= 60; ++i) {
                const double fraction = i / 60.0;
                const double diameter = quantile(sizes, weight, fraction);
                EXPECT_GE(cumulative_fraction(sizes, weight, diameter), fraction) << name;
                const double below = std::nextafter(diameter, 0.0);
                if (diameter > smallest_diameter(sizes)) {
                    EXPECT_LT(cumulative_fraction(sizes, weight, below), fraction) << name;
                }
            }
}

TEST(SizeDistribution, OutsideItsRangeThereIsNothing) {
    auto cases = continuous_cases();
    for (const auto& discrete : discrete_cases()) cases.push_back(discrete);
    for (const auto& [name, sizes] : cases) {
        const double below = 0.999 * smallest_diameter(sizes);
        const double above = 1.001 * largest_diameter(sizes);
        for (const Weight weight : {Weight::number, Weight::volume}) {
            EXPECT_EQ(cumulative_fraction(sizes, weight, below), 0.0) << name;
            EXPECT_EQ(cumulative_fraction(sizes, weight, above), 1.0) << name;
        }
        EXPECT_EQ(number_density(sizes, below), 0.0) << name;
        EXPECT_EQ(number_density(sizes, above), 0.0) << name;
    }
}

TEST(PowerLaw, CumulativeVolumeFractionIsEquation3) {
    for (const double alpha : {-0.4, 0.2, 0.55, 1.0, 1.5})
        for (const double diameter : {1.5, 7.0, 49.0})
            EXPECT_NEAR(cumulative_fraction(PowerLaw{50.0, alpha}, Weight::volume, diameter),
                        (std::pow(diameter, alpha) - 1.0) / (std::pow(50.0, alpha) - 1.0), 1e-14);
    EXPECT_NEAR(cumulative_fraction(PowerLaw{50.0, 0.0}, Weight::volume, 7.0),
                std::log(7.0) / std::log(50.0), 1e-15);
}

TEST(PowerLaw, DensityFallsAsTheExponentBeta) {
    const PowerLaw law{20.0, 0.7};
    const double beta = 4.0 - law.alpha;
    EXPECT_NEAR(number_density(law, 10.0) / number_density(law, 2.0), std::pow(5.0, -beta), 1e-14);
}

// The closed forms divide zero by zero where alpha is 0, 1, 2 or 3; the values must pass through
// these points as smoothly as through any other.
TEST(PowerLaw, IsContinuousAcrossItsSingularExponents) {
    const auto values = [](double alpha, double size_ratio) {
        const SizeDistribution law = PowerLaw{size_ratio, alpha};
        const double middle = std::sqrt(size_ratio);
        return std::vector<double>{
            cumulative_fraction(law, Weight::number, middle),
            cumulative_fraction(law, Weight::volume, middle),
            std::log(quantile(law, Weight::number, 0.9)) / std::log(size_ratio),
            std::log(quantile(law, Weight::volume, 0.4)) / std::log(size_ratio),
            std::log(moment(law, 1.0)) / std::log(size_ratio),
            std::log(moment(law, 2.0)) / std::log(size_ratio),
            std::log(moment(law, 3.0)) / std::log(size_ratio)};
    };
    for (const double alpha : {0.0, 1.0, 2.0, 3.0})
        for (const double size_ratio : {1.0001, 5.0, 1000.0}) {
            const auto at = values(alpha, size_ratio);
            for (const double step : {1e-300, 1e-17, 1e-15, 1e-12, 1e-9, 1e-6})
                for (const double side : {-1.0, 1.0}) {
                    const auto near = values(alpha + side * step, size_ratio);
                    for (std::size_t i = 0; i < at.size(); ++i)
                        EXPECT_NEAR(near[i], at[i], 10.0 * step + 1e-11)
                            << "alpha " << alpha << ", step " << side * step << ", ratio "
                            << size_ratio << ", value " << i;
                }
        }
}

TEST(SizeDistribution, ASizeRatioOfOneIsMonodisperse) {
    for (const SizeDistribution& sizes :
         {SizeDistribution{PowerLaw{1.0, 0.55}}, SizeDistribution{PowerLaw{1.0, 3.0}},
          SizeDistribution{GrainSizeDistribution{1.0, 0.6}}, SizeDistribution{Binary{1.0, 0.3, 5}},
          SizeDistribution{Monodisperse{}}, SizeDistribution{diameter_list({1.0})}})
        for (const Weight weight : {Weight::number, Weight::volume}) {
            check(sizes);
            EXPECT_EQ(quantile(sizes, weight, 0.3), 1.0);
            EXPECT_EQ(cumulative_fraction(sizes, weight, 1.0), 1.0);
            EXPECT_EQ(cumulative_fraction(sizes, weight, 0.9999), 0.0);
            EXPECT_EQ(moment(sizes, 3.0), 1.0);
            EXPECT_TRUE(std::isinf(number_density(sizes, 1.0)));
        }
}

// The only exponent that the two families share (Monti et al., below Eq. 3).
TEST(GrainSizeDistribution, OfExponentOneIsThePowerLawOfExponentOne) {
    const SizeDistribution grains = GrainSizeDistribution{32.0, 1.0};
    const SizeDistribution law = PowerLaw{32.0, 1.0};
    for (const double fraction : {0.001, 0.2, 0.5, 0.9, 0.9999})
        for (const Weight weight : {Weight::number, Weight::volume}) {
            const double diameter = quantile(law, weight, fraction);
            EXPECT_NEAR(quantile(grains, weight, fraction), diameter, 1e-11 * diameter);
            EXPECT_NEAR(number_density(grains, diameter) / number_density(law, diameter), 1.0,
                        1e-11);
        }
    EXPECT_NEAR(moment(grains, 3.0) / moment(law, 3.0), 1.0, 1e-11);
}

TEST(GrainSizeDistribution, CumulativeVolumeFractionIsItsDefinition) {
    const SizeDistribution grains = GrainSizeDistribution{32.0, 0.4};
    EXPECT_NEAR(cumulative_fraction(grains, Weight::volume, 3.1), std::pow(2.1 / 31.0, 0.4), 1e-15);
}

TEST(Lognormal, IsSymmetricAboutItsMedianAndCutAtThreeSigma) {
    const SizeDistribution lognormal = Lognormal{.sigma = 0.4};
    const double median = std::exp(3.0 * 0.4);
    EXPECT_NEAR(largest_diameter(lognormal), median * median, 1e-12);
    EXPECT_NEAR(quantile(lognormal, Weight::number, 0.5), median, 1e-12);
    for (const double fraction : {0.01, 0.2, 0.4})
        EXPECT_NEAR(quantile(lognormal, Weight::number, fraction) *
                        quantile(lognormal, Weight::number, 1.0 - fraction),
                    median * median, 1e-11);
}

TEST(Lognormal, CutFarOutHasTheMomentsOfTheWholeCurve) {
    const double sigma = 0.3;
    const SizeDistribution lognormal = Lognormal{sigma, std::exp(20.0 * sigma)};
    const double median = std::exp(10.0 * sigma);
    for (const double order : {1.0, 2.0, 3.0})
        EXPECT_NEAR(moment(lognormal, order) /
                        (std::pow(median, order) * std::exp(0.5 * std::pow(order * sigma, 2))),
                    1.0, 1e-12);
}

TEST(Binary, FractionsAndMomentsByHand) {
    // f_S = 1/2 at ratio 2: eight small spheres have the volume of a large one.
    const SizeDistribution binary = Binary{2.0, 0.5, 10};
    EXPECT_DOUBLE_EQ(cumulative_fraction(binary, Weight::number, 1.5), 8.0 / 9.0);
    EXPECT_DOUBLE_EQ(cumulative_fraction(binary, Weight::volume, 1.5), 0.5);
    EXPECT_DOUBLE_EQ(moment(binary, 1.0), (8.0 + 2.0) / 9.0);
    EXPECT_DOUBLE_EQ(mean_volume(binary), std::numbers::pi / 6.0 * 16.0 / 9.0);
}

TEST(DiameterList, FractionsAndMomentsByHand) {
    const SizeDistribution list = diameter_list({3.0, 1.0, 2.0, 2.0});
    EXPECT_DOUBLE_EQ(cumulative_fraction(list, Weight::number, 2.0), 0.75);
    EXPECT_DOUBLE_EQ(cumulative_fraction(list, Weight::volume, 2.5), 17.0 / 44.0);
    EXPECT_DOUBLE_EQ(moment(list, 2.0), 18.0 / 4.0);
    EXPECT_DOUBLE_EQ(smallest_diameter(list), 1.0);
    EXPECT_DOUBLE_EQ(largest_diameter(list), 3.0);
    EXPECT_TRUE(std::isinf(number_density(list, 2.0)));
    EXPECT_EQ(number_density(list, 2.5), 0.0);
}

TEST(CumulativeCurve, IsLinearInWhatWasGivenAndKeepsItsPoints) {
    const std::vector<double> diameters = {1.0, 2.0, 5.0};
    const std::vector<double> fractions = {0.0, 0.3, 1.0};
    for (const Weight given : {Weight::number, Weight::volume}) {
        const SizeDistribution curve = cumulative_curve(diameters, fractions, given);
        EXPECT_NEAR(cumulative_fraction(curve, given, 1.5), 0.15, 1e-15);
        EXPECT_NEAR(cumulative_fraction(curve, given, 2.0), 0.3, 1e-15);
        EXPECT_NEAR(cumulative_fraction(curve, given, 3.5), 0.65, 1e-15);
    }
}

// alpha = 1 has a cumulative volume fraction that is linear in D, alpha = 4 has a linear number.
TEST(CumulativeCurve, OfAStraightLineIsAPowerLaw) {
    const SizeDistribution by_volume =
        cumulative_curve({1.0, 7.0, 20.0}, {0.0, 6.0 / 19.0, 1.0}, Weight::volume);
    const SizeDistribution by_number = cumulative_curve({1.0, 20.0}, {0.0, 1.0}, Weight::number);
    for (const double diameter : {1.01, 3.0, 7.0, 15.0})
        for (const Weight weight : {Weight::number, Weight::volume}) {
            EXPECT_NEAR(cumulative_fraction(by_volume, weight, diameter),
                        cumulative_fraction(PowerLaw{20.0, 1.0}, weight, diameter), 1e-13);
            EXPECT_NEAR(cumulative_fraction(by_number, weight, diameter),
                        cumulative_fraction(PowerLaw{20.0, 4.0}, weight, diameter), 1e-13);
        }
}

}  // namespace
}  // namespace jam
