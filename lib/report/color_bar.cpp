// SPDX-License-Identifier: BSD-3-Clause
#include "report/color_bar.h"

#include "report/color_map.h"
#include "report/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace jam {

namespace {

constexpr Rgb ink{0.018F, 0.022F, 0.030F};

/// All lengths of a legend follow from the height of its letters.
struct Layout {
    double letters;    ///< height of a capital
    double bar_width;  ///< of the color bar or a swatch
    double gap;        ///< between a color and its number
    double line;       ///< from one line of text to the next
    double margin;     ///< to the right edge of the picture
    double bar_height;

    explicit Layout(int picture_height)
        : letters(std::max(7.0, picture_height / 62.0)),
          bar_width(1.5 * letters),
          gap(0.9 * letters),
          line(1.9 * letters),
          margin(2.2 * letters),
          bar_height(0.52 * picture_height) {}
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string number_label(double value, double step) {
    const double size = std::abs(value);
    if (value != 0.0 && (size >= 1e5 || size < 1e-3)) {
        const int power = static_cast<int>(std::lround(std::floor(std::log10(size * (1 + 1e-9)))));
        const double factor = value / std::pow(10.0, power);
        if (std::abs(factor - 1.0) < 1e-6) return fmt::format("10^{}", power);
        return fmt::format("{:.3g} x 10^{}", factor, power);
    }
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return fmt::format("{:.{}f}", value, decimals);
}

/// A hundredth beyond an end still counts: diameters drawn from 1 to 50 end a little before.
bool within(const ScaleLegend& scale, double value) {
    const double place = place_on_scale(scale, value);
    return place >= -0.01 && place <= 1.01;
}

std::vector<Tick> logarithmic_ticks(const ScaleLegend& scale) {
    const double decades = std::log10(scale.high / scale.low);
    const int first = static_cast<int>(std::floor(std::log10(scale.low)));
    const int last = static_cast<int>(std::ceil(std::log10(scale.high)));
    std::vector<Tick> ticks;
    for (int power = first; power <= last; ++power)
        for (int digit = 1; digit < 10; ++digit) {
            const double decade = std::pow(10.0, power);
            const double value = digit * decade;
            if (!within(scale, value)) continue;
            const bool numbered = digit == 1 || (decades < 2.5 && (digit == 2 || digit == 5)) ||
                                  (decades < 0.8 && digit != 7 && digit != 9);
            ticks.push_back({value, numbered ? number_label(value, decade) : ""});
        }
    return ticks;
}

/// 1, 2 or 5 times a power of ten, about a fifth of the range.
double round_step(double range) {
    const double rough = range / 4.5;
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= rough) return factor * decade;
    return 10.0 * decade;
}

std::vector<Tick> linear_ticks(const ScaleLegend& scale) {
    const double step = round_step(scale.high - scale.low);
    std::vector<Tick> ticks;
    const auto first = std::lround(std::floor(scale.low / step));
    const auto last = std::lround(std::ceil(scale.high / step));
    for (long k = first; k <= last; ++k) {
        const double value = static_cast<double>(k) * step;
        if (within(scale, value)) ticks.push_back({value, number_label(value, step)});
    }
    return ticks;
}

double widest(const std::vector<std::string>& lines, double letters) {
    double width = 0.0;
    for (const std::string& line : lines) width = std::max(width, text_width(line, letters));
    return width;
}

double content_width(const ScaleLegend& scale, const Layout& layout) {
    std::vector<std::string> numbers;
    for (const Tick& tick : scale_ticks(scale)) numbers.push_back(tick.label);
    return std::max(widest(lines_of(scale.title), layout.letters),
                    layout.bar_width + layout.gap + widest(numbers, layout.letters));
}

double content_width(const KindLegend& kinds, const Layout& layout) {
    std::vector<std::string> names;
    for (const KindLegend::Entry& entry : kinds.entries) names.push_back(entry.name);
    return layout.bar_width + layout.gap + widest(names, layout.letters);
}

double content_width(const std::variant<ScaleLegend, KindLegend>& legend, const Layout& layout) {
    return std::visit([&](const auto& kind) { return content_width(kind, layout); }, legend);
}

void draw_bar(Canvas& canvas, const Spot& top_left, const Layout& layout) {
    const int rows = static_cast<int>(std::ceil(layout.bar_height));
    for (int row = 0; row < rows; ++row) {
        const double y = top_left.y + row;
        const double y_end = std::min(y + 1.0, top_left.y + layout.bar_height);
        fill_rectangle(canvas, {top_left.x, y}, {top_left.x + layout.bar_width, y_end},
                       scale_color(1.0 - (row + 0.5) / layout.bar_height));
    }
}

void draw_scale(Canvas& canvas, const ScaleLegend& scale, const Layout& layout, double left) {
    const std::vector<std::string> title = lines_of(scale.title);
    const double title_height = layout.line * static_cast<double>(title.size());
    const double top =
        std::round(0.5 * (canvas.height - layout.bar_height - title_height) + title_height);
    for (std::size_t k = 0; k < title.size(); ++k)
        draw_text(canvas, title[k],
                  {left, top - title_height + layout.line * (static_cast<double>(k) + 0.45)},
                  layout.letters, TextAlign::left, ink);
    draw_bar(canvas, {left, top}, layout);
    const double right = left + layout.bar_width;
    for (const Tick& tick : scale_ticks(scale)) {
        const double place = std::clamp(place_on_scale(scale, tick.value), 0.0, 1.0);
        const double y = top + layout.bar_height * (1.0 - place);
        const double length = (tick.label.empty() ? 0.2 : 0.45) * layout.letters;
        draw_stroke(canvas, {{right + 1.0, y}, {right + length, y}}, layout.letters / 12.0, ink);
        draw_text(canvas, tick.label, {right + layout.gap, y + 0.5 * layout.letters},
                  layout.letters, TextAlign::left, ink);
    }
}

void draw_kinds(Canvas& canvas, const KindLegend& kinds, const Layout& layout, double left) {
    const double pitch = 1.5 * layout.line;
    double y = std::round(
        0.5 * (canvas.height - pitch * static_cast<double>(kinds.entries.size())) + layout.line);
    for (const KindLegend::Entry& entry : kinds.entries) {
        const double middle = y - 0.5 * layout.letters;
        draw_stroke(canvas, {{left + 0.5 * layout.bar_width, middle}}, layout.bar_width,
                    entry.color);
        draw_text(canvas, entry.name, {left + layout.bar_width + layout.gap, y}, layout.letters,
                  TextAlign::left, ink);
        y += pitch;
    }
}

}  // namespace

std::vector<Tick> scale_ticks(const ScaleLegend& scale) {
    if (!(scale.high > scale.low)) return {{scale.low, fmt::format("{:.4g}", scale.low)}};
    return scale.logarithmic ? logarithmic_ticks(scale) : linear_ticks(scale);
}

int legend_width(const std::variant<ScaleLegend, KindLegend>& legend, int picture_height) {
    const Layout layout(picture_height);
    return static_cast<int>(std::ceil(content_width(legend, layout) + layout.margin));
}

void draw_legend(Canvas& canvas, const std::variant<ScaleLegend, KindLegend>& legend) {
    const Layout layout(canvas.height);
    const double left = canvas.width - legend_width(legend, canvas.height);
    if (const auto* scale = std::get_if<ScaleLegend>(&legend))
        draw_scale(canvas, *scale, layout, left);
    else
        draw_kinds(canvas, std::get<KindLegend>(legend), layout, left);
}

}  // namespace jam
