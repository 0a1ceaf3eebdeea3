// SPDX-License-Identifier: BSD-3-Clause
// The color of every sphere of a picture, and the legend that explains it.
#pragma once

#include "analysis/contact_network.h"
#include "packing/packing.h"
#include "report/canvas.h"

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace jam {

/// A color bar from `low` to `high`. The title may have several lines ('\n').
struct ScaleLegend {
    std::string title;
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
};

/// Named colors.
struct KindLegend {
    struct Entry {
        std::string name;
        Rgb color;
    };
    std::vector<Entry> entries;
};

struct Appearance {
    std::vector<Rgb> colors;           ///< one a sphere
    std::vector<std::uint8_t> hidden;  ///< 1: left out of the picture; empty: all are shown
    std::variant<ScaleLegend, KindLegend> legend;
};

/// Where `value` stands on the scale: 0 at its low end, 1 at its high end.
double place_on_scale(const ScaleLegend& scale, double value);

/// Values on the sequential scale between the smallest and the largest of them; NaN is drawn in
/// the neutral color. The scale is logarithmic if all values are above zero and span more than a
/// factor of four.
Appearance color_by_values(std::span<const double> values, const std::string& title);

/// By diameter.
Appearance color_by_diameter(const Packing& packing);

/// By the number of contacts; spheres without any are neutral.
Appearance color_by_coordination(const Packing& packing, std::span<const Contact> contacts);

/// By the largest contact force on the sphere over the mean contact force of the packing; spheres
/// without contacts are neutral. The scale ends at a fiftieth of the largest force.
Appearance color_by_force(const Packing& packing, std::span<const Contact> contacts);

/// Rattlers (1 in `is_rattler`) apart from the backbone.
Appearance color_by_rattler(std::span<const std::uint8_t> is_rattler);

}  // namespace jam
