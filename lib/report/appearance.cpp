// SPDX-License-Identifier: BSD-3-Clause
#include "report/appearance.h"

#include "report/color_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Range range_of(std::span<const double> values) {
    Range range;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    }
    return range.low <= range.high ? range : Range{0.0, 0.0};
}

/// Every value's place on the scale as a color, beyond its ends that of the end.
Appearance color_on_scale(std::span<const double> values, const ScaleLegend& scale) {
    Appearance appearance{{}, {}, scale};
    appearance.colors.reserve(values.size());
    for (const double value : values)
        appearance.colors.push_back(std::isnan(value) ? neutral_color()
                                                      : scale_color(place_on_scale(scale, value)));
    return appearance;
}

/// Logarithmic where the values span more than this factor.
constexpr double logarithmic_from = 4.0;

}  // namespace

double place_on_scale(const ScaleLegend& scale, double value) {
    if (!(scale.high > scale.low)) return 0.5;
    if (scale.logarithmic) return std::log(value / scale.low) / std::log(scale.high / scale.low);
    return (value - scale.low) / (scale.high - scale.low);
}

Appearance color_by_values(std::span<const double> values, const std::string& title) {
    const Range range = range_of(values);
    const bool logarithmic = range.low > 0.0 && range.high > logarithmic_from * range.low;
    return color_on_scale(values, {title, range.low, range.high, logarithmic});
}

Appearance color_by_diameter(const Packing& packing) {
    return color_by_values(packing.diameters, "diameter");
}

Appearance color_by_coordination(const Packing& packing, std::span<const Contact> contacts) {
    std::vector<double> counts(packing.diameters.size(), 0.0);
    for (const Contact& contact : contacts) {
        counts[contact.first] += 1.0;
        counts[contact.second] += 1.0;
    }
    std::ranges::replace(counts, 0.0, no_value);
    return color_by_values(counts, "contacts");
}

Appearance color_by_force(const Packing& packing, std::span<const Contact> contacts) {
    double sum = 0.0;
    for (const Contact& contact : contacts) sum += contact.force;
    const double mean = sum / static_cast<double>(contacts.size());
    std::vector<double> largest(packing.diameters.size(), 0.0);
    for (const Contact& contact : contacts)
        for (const Index sphere : {contact.first, contact.second}) {
            double& force = largest[sphere];
            force = std::max(force, contact.force / mean);
        }
    std::ranges::replace(largest, 0.0, no_value);
    // A few spheres that hardly touch would else take up most of the scale.
    constexpr double widest = 50.0;
    const Range range = range_of(largest);
    const double low = std::max(range.low, range.high / widest);
    return color_on_scale(largest, {"largest force\n/ mean force", low, range.high,
                                    range.high > logarithmic_from * low});
}

Appearance color_by_rattler(std::span<const std::uint8_t> is_rattler) {
    const Rgb backbone = scale_color(0.3);
    const Rgb rattler = scale_color(1.0);
    Appearance appearance{{}, {}, KindLegend{{{"backbone", backbone}, {"rattlers", rattler}}}};
    appearance.colors.reserve(is_rattler.size());
    for (const std::uint8_t loose : is_rattler)
        appearance.colors.push_back(loose != 0 ? rattler : backbone);
    return appearance;
}

}  // namespace jam
