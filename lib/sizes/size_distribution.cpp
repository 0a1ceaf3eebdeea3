// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/size_distribution.h"

#include "sizes/power_segment.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <limits>
#include <numbers>

namespace jam {

// Every kind answers the same five questions (range, density, cumulative, quantile_of, mean_power),
// as overloads among which std::visit picks. The public functions at the end see to what is the
// same for all kinds: diameters outside the range, and a range of no width.
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct DiameterRange {
    double smallest;
    double largest;
};

// The order of the moment that a weight stands for: density D^order n(D).
double order_of(Weight weight) {
    return weight == Weight::volume ? 3.0 : 0.0;
}

// ---- power law: n(D) ~ D^(p - 1) with p = alpha - 3, so volume ~ D^(alpha - 1)

double exponent(const PowerLaw& law, double order) {
    return law.alpha - 3.0 + order;
}

DiameterRange range(const PowerLaw& law) {
    return {1.0, law.size_ratio};
}

double density(const PowerLaw& law, double diameter) {
    const double p = exponent(law, 0.0);
    return std::pow(diameter, p - 1.0) / power_integral(p, 1.0, law.size_ratio);
}

double cumulative(const PowerLaw& law, Weight weight, double diameter) {
    return power_fraction(exponent(law, order_of(weight)), 1.0, law.size_ratio, diameter);
}

double quantile_of(const PowerLaw& law, Weight weight, double fraction) {
    return power_quantile(exponent(law, order_of(weight)), 1.0, law.size_ratio, fraction);
}

double mean_power(const PowerLaw& law, double order) {
    return power_integral(exponent(law, order), 1.0, law.size_ratio) /
           power_integral(exponent(law, 0.0), 1.0, law.size_ratio);
}

// ---- binary

// Fraction of the particles, or of their volume, that is small.
double small_share(const Binary& binary, Weight weight) {
    const double small = binary.small_fraction;
    if (weight == Weight::volume) return small;
    const double volume_ratio = std::pow(binary.size_ratio, 3);
    return small * volume_ratio / (small * volume_ratio + 1.0 - small);
}

DiameterRange range(const Binary& binary) {
    return {1.0, binary.size_ratio};
}

double density(const Binary& binary, double diameter) {
    return diameter == 1.0 || diameter == binary.size_ratio ? infinite : 0.0;
}

double cumulative(const Binary& binary, Weight weight, double /*diameter*/) {
    return small_share(binary, weight);
}

double quantile_of(const Binary& binary, Weight weight, double fraction) {
    return fraction <= small_share(binary, weight) ? 1.0 : binary.size_ratio;
}

double mean_power(const Binary& binary, double order) {
    const double small = small_share(binary, Weight::number);
    return small + (1.0 - small) * std::pow(binary.size_ratio, order);
}

// ---- monodisperse: a range of no width, so only its moments are ever asked for

DiameterRange range(const Monodisperse&) {
    return {1.0, 1.0};
}

double density(const Monodisperse&, double /*diameter*/) {
    return infinite;
}

double cumulative(const Monodisperse&, Weight, double /*diameter*/) {
    return 1.0;
}

double quantile_of(const Monodisperse&, Weight, double /*fraction*/) {
    return 1.0;
}

double mean_power(const Monodisperse&, double /*order*/) {
    return 1.0;
}

// ---- grain-size distribution: with v the cumulative volume fraction, D = 1 + (lambda - 1)
// v^(1/eta) and n(D) ~ (D - 1)^(eta - 1) D^-3. In t = 1 - 1/D the number below D is the incomplete
// beta function B(t; eta, 3 - eta).

// ibeta without the detour through long double, which costs ten times as much for digits that a
// double cannot hold.
using DoubleOnly = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

double beta_fraction(const GrainSizeDistribution& grains, double diameter) {
    return boost::math::ibeta(grains.eta, 3.0 - grains.eta, 1.0 - 1.0 / diameter, DoubleOnly());
}

DiameterRange range(const GrainSizeDistribution& grains) {
    return {1.0, grains.size_ratio};
}

double density(const GrainSizeDistribution& grains, double diameter) {
    const double all =
        boost::math::beta(grains.eta, 3.0 - grains.eta, 1.0 - 1.0 / grains.size_ratio);
    return std::pow(diameter - 1.0, grains.eta - 1.0) * std::pow(diameter, -3.0) / all;
}

double cumulative(const GrainSizeDistribution& grains, Weight weight, double diameter) {
    if (weight == Weight::volume)
        return std::pow((diameter - 1.0) / (grains.size_ratio - 1.0), grains.eta);
    return beta_fraction(grains, diameter) / beta_fraction(grains, grains.size_ratio);
}

double quantile_of(const GrainSizeDistribution& grains, Weight weight, double fraction) {
    if (weight == Weight::volume)
        return 1.0 + (grains.size_ratio - 1.0) * std::pow(fraction, 1.0 / grains.eta);
    const double all = beta_fraction(grains, grains.size_ratio);
    const double t =
        boost::math::ibeta_inv(grains.eta, 3.0 - grains.eta, fraction * all, DoubleOnly());
    return 1.0 / (1.0 - t);
}

double mean_power(const GrainSizeDistribution& grains, double order) {
    boost::math::quadrature::tanh_sinh<double> quadrature;
    const auto mean_over_volume = [&](double power) {
        return quadrature.integrate(
            [&](double v) { return std::pow(quantile_of(grains, Weight::volume, v), power); }, 0.0,
            1.0);
    };
    return mean_over_volume(order - 3.0) / mean_over_volume(-3.0);
}

// ---- lognormal: D^order n(D) is the same curve shifted by order sigma^2 in ln D

double half_width(const Lognormal& lognormal) {
    return 0.5 * std::log(lognormal.size_ratio) / lognormal.sigma;
}

// Standard deviations of ln D from its median.
double deviation(const Lognormal& lognormal, double diameter) {
    return std::log(diameter) / lognormal.sigma - half_width(lognormal);
}

// Probability of a standard normal variable between a and b; the smaller tails are subtracted.
double normal_between(double a, double b) {
    const double scale = std::numbers::sqrt2 / 2.0;
    if (a > 0.0) return 0.5 * (std::erfc(a * scale) - std::erfc(b * scale));
    return 0.5 * (std::erfc(-b * scale) - std::erfc(-a * scale));
}

double normal_quantile(double probability) {
    if (probability <= 0.0) return -infinite;
    if (probability >= 1.0) return infinite;
    return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * probability, DoubleOnly());
}

DiameterRange range(const Lognormal& lognormal) {
    return {1.0, lognormal.size_ratio};
}

double density(const Lognormal& lognormal, double diameter) {
    const double c = half_width(lognormal);
    const double z = deviation(lognormal, diameter);
    return std::exp(-0.5 * z * z) /
           (std::sqrt(2.0 * std::numbers::pi) * lognormal.sigma * diameter * normal_between(-c, c));
}

double cumulative(const Lognormal& lognormal, Weight weight, double diameter) {
    const double c = half_width(lognormal);
    const double shift = order_of(weight) * lognormal.sigma;
    return normal_between(-c - shift, deviation(lognormal, diameter) - shift) /
           normal_between(-c - shift, c - shift);
}

double quantile_of(const Lognormal& lognormal, Weight weight, double fraction) {
    const double c = half_width(lognormal);
    const double shift = order_of(weight) * lognormal.sigma;
    const double below = normal_between(-infinite, -c - shift);
    const double z =
        normal_quantile(below + fraction * normal_between(-c - shift, c - shift)) + shift;
    return std::exp((z + c) * lognormal.sigma);
}

double mean_power(const Lognormal& lognormal, double order) {
    const double c = half_width(lognormal);
    const double shift = order * lognormal.sigma;
    return std::pow(lognormal.size_ratio, 0.5 * order) * std::exp(0.5 * shift * shift) *
           normal_between(-c - shift, c - shift) / normal_between(-c, c);
}

// ---- table: a list of diameters

DiameterRange range(const DiameterList& list) {
    return {list.diameters.front(), list.diameters.back()};
}

double density(const DiameterList& list, double diameter) {
    return std::ranges::binary_search(list.diameters, diameter) ? infinite : 0.0;
}

double cumulative(const DiameterList& list, Weight weight, double diameter) {
    const auto count = std::ranges::upper_bound(list.diameters, diameter) - list.diameters.begin();
    if (weight == Weight::volume) return list.volume_fractions[static_cast<std::size_t>(count - 1)];
    return static_cast<double>(count) / static_cast<double>(list.diameters.size());
}

double quantile_of(const DiameterList& list, Weight weight, double fraction) {
    if (weight == Weight::volume) {
        const auto at = std::ranges::lower_bound(list.volume_fractions, fraction);
        return list.diameters[static_cast<std::size_t>(at - list.volume_fractions.begin())];
    }
    const double count = static_cast<double>(list.diameters.size());
    double at = std::max(0.0, std::ceil(fraction * count) - 1.0);
    if (at > 0.0 && at / count >= fraction) at -= 1.0;  // fraction * count was rounded up
    return list.diameters[static_cast<std::size_t>(at)];
}

double mean_power(const DiameterList& list, double order) {
    double sum = 0.0;
    for (const double diameter : list.diameters) sum += std::pow(diameter, order);
    return sum / static_cast<double>(list.diameters.size());
}

// ---- table: a cumulative curve; between two points n(D) ~ D^(p - 1)

double exponent(const CumulativeCurve& curve, double order) {
    return (curve.given == Weight::volume ? -2.0 : 1.0) + order;
}

const std::vector<double>& fractions(const CumulativeCurve& curve, Weight weight) {
    return weight == Weight::volume ? curve.volume_fractions : curve.number_fractions;
}

// The i with diameters[i] <= D < diameters[i + 1].
std::size_t segment_at(const CumulativeCurve& curve, double diameter) {
    const auto above = std::ranges::upper_bound(curve.diameters, diameter);
    const auto last = static_cast<std::ptrdiff_t>(curve.diameters.size()) - 1;
    return static_cast<std::size_t>(std::min(above - curve.diameters.begin(), last) - 1);
}

DiameterRange range(const CumulativeCurve& curve) {
    return {curve.diameters.front(), curve.diameters.back()};
}

double density(const CumulativeCurve& curve, double diameter) {
    const std::size_t i = segment_at(curve, diameter);
    const double p = exponent(curve, 0.0);
    return (curve.number_fractions[i + 1] - curve.number_fractions[i]) *
           std::pow(diameter, p - 1.0) /
           power_integral(p, curve.diameters[i], curve.diameters[i + 1]);
}

double cumulative(const CumulativeCurve& curve, Weight weight, double diameter) {
    const std::size_t i = segment_at(curve, diameter);
    const std::vector<double>& at = fractions(curve, weight);
    return std::lerp(at[i], at[i + 1],
                     power_fraction(exponent(curve, order_of(weight)), curve.diameters[i],
                                    curve.diameters[i + 1], diameter));
}

double quantile_of(const CumulativeCurve& curve, Weight weight, double fraction) {
    const std::vector<double>& at = fractions(curve, weight);
    const auto reached = std::ranges::lower_bound(at, fraction) - at.begin();
    if (reached == 0) return curve.diameters.front();
    const auto i = static_cast<std::size_t>(reached - 1);
    return power_quantile(exponent(curve, order_of(weight)), curve.diameters[i],
                          curve.diameters[i + 1], (fraction - at[i]) / (at[i + 1] - at[i]));
}

double mean_power(const CumulativeCurve& curve, double order) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < curve.diameters.size(); ++i) {
        const double from = curve.diameters[i];
        const double to = curve.diameters[i + 1];
        sum += (curve.number_fractions[i + 1] - curve.number_fractions[i]) *
               power_integral(exponent(curve, order), from, to) /
               power_integral(exponent(curve, 0.0), from, to);
    }
    return sum;
}

DiameterRange range_of(const SizeDistribution& sizes) {
    return std::visit([](const auto& kind) { return range(kind); }, sizes);
}

}  // namespace

double smallest_diameter(const SizeDistribution& sizes) {
    return range_of(sizes).smallest;
}

double largest_diameter(const SizeDistribution& sizes) {
    return range_of(sizes).largest;
}

double number_density(const SizeDistribution& sizes, double diameter) {
    const auto [smallest, largest] = range_of(sizes);
    if (!(diameter >= smallest && diameter <= largest)) return 0.0;
    if (smallest == largest) return infinite;
    return std::visit([&](const auto& kind) { return density(kind, diameter); }, sizes);
}

double cumulative_fraction(const SizeDistribution& sizes, Weight weight, double diameter) {
    const auto [smallest, largest] = range_of(sizes);
    if (diameter < smallest) return 0.0;
    if (diameter >= largest) return 1.0;
    return std::visit([&](const auto& kind) { return cumulative(kind, weight, diameter); }, sizes);
}

double quantile(const SizeDistribution& sizes, Weight weight, double fraction) {
    const auto [smallest, largest] = range_of(sizes);
    if (smallest == largest) return smallest;
    const double diameter =
        std::visit([&](const auto& kind) { return quantile_of(kind, weight, fraction); }, sizes);
    return std::clamp(diameter, smallest, largest);
}

double moment(const SizeDistribution& sizes, double order) {
    const auto [smallest, largest] = range_of(sizes);
    if (smallest == largest) return std::pow(smallest, order);
    return std::visit([&](const auto& kind) { return mean_power(kind, order); }, sizes);
}

double mean_volume(const SizeDistribution& sizes) {
    return std::numbers::pi / 6.0 * moment(sizes, 3.0);
}

}  // namespace jam
