// SPDX-License-Identifier: BSD-3-Clause
// Lines and lettering on a canvas, with smooth edges. The lettering is drawn with strokes of its
// own, so that a picture needs no font and has the same bits on every machine.
#pragma once

#include "report/canvas.h"

#include <string_view>
#include <vector>

namespace jam {

/// A place on the canvas in pixels, from the top left corner; pixel centers at half-integers.
struct Spot {
    double x = 0.0, y = 0.0;
};

/// A stroke of the given width with round ends and joints through all `spots`.
void draw_stroke(Canvas& canvas, const std::vector<Spot>& spots, double width, const Rgb& color);

void fill_rectangle(Canvas& canvas, const Spot& top_left, const Spot& bottom_right,
                    const Rgb& color);

enum class TextAlign { left, center, right };

/// Writes `text` on the base line through `at`, capitals `height` pixels high. Letters, digits,
/// space and . , - + / ( ) = % : are known (others show as a box); `^` raises all that follows up
/// to the next space.
void draw_text(Canvas& canvas, std::string_view text, const Spot& at, double height,
               TextAlign align, const Rgb& color);

/// Width of the text in pixels.
double text_width(std::string_view text, double height);

}  // namespace jam
