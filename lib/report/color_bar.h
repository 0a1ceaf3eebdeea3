// SPDX-License-Identifier: BSD-3-Clause
// The legend beside a picture.
#pragma once

#include "report/appearance.h"
#include "report/canvas.h"

#include <string>
#include <vector>

namespace jam {

/// A mark on a scale.
struct Tick {
    double value;
    std::string label;  ///< empty: a small mark without a number
};

/// Marks at round values within the scale: about five of them with numbers.
std::vector<Tick> scale_ticks(const ScaleLegend& scale);

/// Width in pixels that a legend needs on a picture of this height.
int legend_width(const std::variant<ScaleLegend, KindLegend>& legend, int picture_height);

/// Draws the legend at the right edge of the canvas.
void draw_legend(Canvas& canvas, const std::variant<ScaleLegend, KindLegend>& legend);

}  // namespace jam
