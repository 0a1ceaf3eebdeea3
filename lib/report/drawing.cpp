// SPDX-License-Identifier: BSD-3-Clause
#include "report/drawing.h"

#include "report/lettering.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

double distance_to_segment(const Spot& p, const Spot& a, const Spot& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    const double along =
        squared > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

double distance_to_stroke(const Spot& p, const std::vector<Spot>& spots) {
    double nearest = std::hypot(p.x - spots[0].x, p.y - spots[0].y);
    for (std::size_t k = 1; k < spots.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(p, spots[k - 1], spots[k]));
    return nearest;
}

struct PixelBox {
    int x_begin, x_end, y_begin, y_end;
};

/// The pixels of the canvas within `margin` of the spots.
PixelBox box_around(const Canvas& canvas, const std::vector<Spot>& spots, double margin) {
    const auto [left, right] = std::ranges::minmax(spots, {}, &Spot::x);
    const auto [top, bottom] = std::ranges::minmax(spots, {}, &Spot::y);
    const auto inside = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    return {inside(left.x - margin, canvas.width), inside(right.x + margin + 1.0, canvas.width),
            inside(top.y - margin, canvas.height), inside(bottom.y + margin + 1.0, canvas.height)};
}

struct Raised {
    double shift = 0.0;
    double size = 1.0;
};

/// Calls visit(letter, left edge, raised) for each letter, in units; returns the whole width.
template <typename Visit>
double for_each_letter(std::string_view text, Visit&& visit) {
    Raised raised;
    double x = 0.0;
    for (const char character : text) {
        if (character == '^') {
            raised = {3.6, 0.68};
            continue;
        }
        if (character == ' ') raised = {};
        const Letter& drawn = letter(character);
        visit(drawn, x, raised);
        x += raised.size * (drawn.width + letter_gap);
    }
    return x > 0.0 ? x - raised.size * letter_gap : 0.0;
}

}  // namespace

void draw_stroke(Canvas& canvas, const std::vector<Spot>& spots, double width, const Rgb& color) {
    if (spots.empty()) return;
    const double half = 0.5 * width;
    const PixelBox box = box_around(canvas, spots, half + 1.0);
    for (int y = box.y_begin; y < box.y_end; ++y)
        for (int x = box.x_begin; x < box.x_end; ++x) {
            const double distance = distance_to_stroke({x + 0.5, y + 0.5}, spots);
            const double coverage = std::clamp(half + 0.5 - distance, 0.0, 1.0);
            Rgb& pixel = canvas.at(x, y);
            pixel = blend(pixel, color, static_cast<float>(coverage));
        }
}

void fill_rectangle(Canvas& canvas, const Spot& top_left, const Spot& bottom_right,
                    const Rgb& color) {
    const PixelBox box = box_around(canvas, {top_left, bottom_right}, 0.0);
    const auto overlap = [](int pixel, double from, double to) {
        return std::clamp(std::min(pixel + 1.0, to) - std::max<double>(pixel, from), 0.0, 1.0);
    };
    for (int y = box.y_begin; y < box.y_end; ++y)
        for (int x = box.x_begin; x < box.x_end; ++x) {
            const double coverage =
                overlap(x, top_left.x, bottom_right.x) * overlap(y, top_left.y, bottom_right.y);
            Rgb& pixel = canvas.at(x, y);
            pixel = blend(pixel, color, static_cast<float>(coverage));
        }
}

void draw_text(Canvas& canvas, std::string_view text, const Spot& at, double height,
               TextAlign align, const Rgb& color) {
    const double unit = height / capital_height;
    const double width = text_width(text, height);
    const double left = at.x - (align == TextAlign::left     ? 0.0
                                : align == TextAlign::center ? 0.5 * width
                                                             : width);
    for_each_letter(text, [&](const Letter& drawn, double x, const Raised& raised) {
        for (std::vector<Spot> stroke : drawn.strokes) {
            for (Spot& spot : stroke)
                spot = {left + unit * (x + raised.size * spot.x),
                        at.y - unit * (raised.shift + raised.size * spot.y)};
            draw_stroke(canvas, stroke, unit * pen_width * (raised.size < 1.0 ? 0.85 : 1.0), color);
        }
    });
}

double text_width(std::string_view text, double height) {
    return height / capital_height *
           for_each_letter(text, [](const Letter&, double, const Raised&) {});
}

}  // namespace jam
