// SPDX-License-Identifier: BSD-3-Clause
#include "report/figure.h"

#include "core/check.h"
#include "core/parallel.h"
#include "core/whole_file.h"
#include "report/child_program.h"
#include "report/color_map.h"

#include <fmt/format.h>

#include <cmath>

namespace jam {

namespace {

constexpr const char* style_body = R"gnuplot(
set encoding utf8
set datafile separator comma
typeface = "Helvetica"
ink = "#1f2630"
quiet = "#8b929c"
faint = "#e6e8ec"

# Color at t of the sequential scale, 0 to 1; color of curve i of n on white paper.
scale_color(t) = word(scale_colors, 1 + int(64*(t < 0 ? 0 : t > 1 ? 1 : t) + 0.5))
curve_color(i, n) = scale_color(n > 1 ? 0.08 + (n == 2 ? 0.52 : 0.74)*(i - 1.0)/(n - 1) : 0.25)
kind_color(i) = word(kind_colors, i)

# What to do before drawing NAME in one format: eval(canvas("NAME", format, width, height)).
canvas(name, format, width, height) = format eq "svg" \
    ? sprintf('set terminal svg size %d,%d enhanced font "%s,14" linewidth 1.3 background "white"; set output "%s.svg"', \
              width, height, typeface, name) \
    : sprintf('set terminal pngcairo size %d,%d enhanced font "%s,14" fontscale 2 linewidth 2.6 pointscale 2; set output "%s.png"', \
              2*width, 2*height, typeface, name)

# Marks at 1, 2 and 5 of every decade, for an axis that spans only a few: eval(round_tics("x"))
round_marks = ""
do for [k = -5:5] { do for [d in "1 2 5"] { round_marks = round_marks.(round_marks eq "" ? "" : ", ").sprintf("%g", d*10.0**k) } }
round_tics(axis) = "set ".axis."tics (".round_marks.")"

set border 3 linecolor rgb ink linewidth 0.8
set tics nomirror out scale 0.7,0.4 textcolor rgb ink
set grid linecolor rgb faint linewidth 0.7 linetype 1
set key textcolor rgb ink reverse Left samplen 2.2 spacing 1.25
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set cblabel textcolor rgb ink
set title textcolor rgb ink
set lmargin 9.5
set bmargin 4.3
set bars 0.4
)gnuplot";

std::string color_words(int count, const std::function<Rgb(int)>& color) {
    std::string words;
    for (int i = 0; i < count; ++i)
        words += fmt::format("{}{}", i == 0 ? "" : " ", hex_color(color(i)));
    return words;
}

std::string palette_line() {
    constexpr int steps = 32;
    std::string line = "set palette defined (";
    for (int i = 0; i <= steps; ++i)
        line += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i,
                            hex_color(scale_color(static_cast<double>(i) / steps)));
    return line + ")\n";
}

}  // namespace

std::string script_value(const std::string& name, double value) {
    return std::isnan(value) ? fmt::format("{} = NaN\n", name)
                             : fmt::format("{} = {:.17g}\n", name, value);
}

std::string script_value(const std::string& name, const std::string& text) {
    return fmt::format("{} = \"{}\"\n", name, text);
}

std::string style_script() {
    const std::string scale =
        color_words(65, [](int i) { return scale_color(static_cast<double>(i) / 64.0); });
    const std::string kinds = color_words(8, [](int i) { return kind_color(i); });
    return "# The look of every figure in this folder. Change it, then draw again: gnuplot "
           "NAME.gp\n" +
           script_value("scale_colors", scale) + script_value("kind_colors", kinds) +
           palette_line() + style_body;
}

void write_figures(std::span<const Figure> figures, const std::filesystem::path& folder) {
    make_folder(folder, "name another with -o");
    write_whole_file(folder / "style.gp", style_script());
    for (const Figure& figure : figures) {
        for (const Figure::Data& data : figure.data)
            write_whole_file(folder / (data.name + ".csv"), csv_text(data.table));
        write_whole_file(folder / (figure.name + ".gp"),
                         "# " + figure.title + "\nload \"style.gp\"\n" + figure.script);
    }
}

Drawing draw_figures(std::span<const Figure> figures, const std::filesystem::path& folder) {
    std::vector<ChildRun> runs(figures.size());
    for_each_task(static_cast<Count>(figures.size()), [&](Count i) {
        runs[i] = run_child({"gnuplot", figures[i].name + ".gp"}, folder);
    });
    Drawing drawing;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        drawing.gnuplot_found = drawing.gnuplot_found && runs[i].found;
        if (runs[i].found && runs[i].status != 0)
            drawing.problems.push_back(figures[i].name + ": " + runs[i].words);
    }
    return drawing;
}

}  // namespace jam
