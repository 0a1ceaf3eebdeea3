// SPDX-License-Identifier: BSD-3-Clause
#include "report/group_figures.h"

#include "core/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace jam {

namespace {

constexpr double no_estimate = std::numeric_limits<double>::quiet_NaN();

std::vector<PowerLaw> laws_of(std::span<const PackingGroup> groups) {
    std::vector<PowerLaw> laws;
    for (const PackingGroup& group : groups)
        if (group.sizes.law) laws.push_back(*group.sizes.law);
    return laws;
}

std::set<double> size_ratios_of(std::span<const PackingGroup> groups) {
    std::set<double> ratios;
    for (const PowerLaw& law : laws_of(groups)) ratios.insert(law.size_ratio);
    return ratios;
}

std::string words_of(const std::set<double>& numbers) {
    std::string words;
    for (const double number : numbers)
        words += fmt::format("{}{:.10g}", words.empty() ? "" : " ", number);
    return words;
}

/// Script lines that every figure against alpha begins with.
std::string against_alpha(std::span<const PackingGroup> groups) {
    const std::vector<PowerLaw> laws = laws_of(groups);
    const auto [low, high] = std::ranges::minmax(laws, {}, &PowerLaw::alpha);
    return script_value("size_ratios", words_of(size_ratios_of(groups))) +
           script_value("lowest_alpha", low.alpha) + script_value("highest_alpha", high.alpha) +
           R"gnuplot(data = "groups.csv"
set xlabel "exponent α"
set xrange [lowest_alpha - 0.05:highest_alpha + 0.05]
n = words(size_ratios)
# The rows of the i-th size ratio, and their values; one packing alone has no error.
error_of(name) = column(name) > 0 ? column(name) : 0
of(i, name) = column("size_ratio") == word(size_ratios, i) + 0 ? column(name) : NaN
label_of(i) = "λ = ".word(size_ratios, i)
)gnuplot";
}

Figure::Data groups_data(std::span<const PackingGroup> groups) {
    return {"groups", groups_table(groups)};
}

Table rod_table(std::span<const PackingGroup> groups) {
    const std::vector<PowerLaw> laws = laws_of(groups);
    const auto [low, high] = std::ranges::minmax(laws, {}, &PowerLaw::alpha);
    constexpr int steps = 16;
    std::vector<PowerLaw> points;
    for (const double ratio : size_ratios_of(groups))
        for (int k = 0; k <= steps; ++k)
            points.push_back(
                {ratio, low.alpha - 0.05 + (high.alpha - low.alpha + 0.1) * k / steps});
    Table table{{{"size_ratio", {}}, {"alpha", {}}, {"volume_fraction", {}}}};
    for (const PowerLaw& law : points) {
        table.columns[0].values.push_back(law.size_ratio);
        table.columns[1].values.push_back(law.alpha);
    }
    RodModel model = rod_model_of_reports;
    model.rod_count = 100'000;
    table.columns[2].values.resize(points.size());
    for_each_task(static_cast<Count>(points.size()), [&](Count i) {
        table.columns[2].values[i] = rod_packing_fraction(points[i], model);
    });
    return table;
}

/// Rows of `table` behind columns that say which group and packing they are of, and an empty row,
/// so that no line joins one packing's curve to the next.
void append_rows(Table& all, const PowerLaw& law, int packing, const Table& table) {
    if (all.columns.empty()) {
        all.columns = {{"size_ratio", {}}, {"alpha", {}}, {"packing", {}}};
        for (const Column& column : table.columns) all.columns.push_back({column.name, {}});
    }
    const std::size_t rows = table.columns.front().values.size();
    for (std::size_t row = 0; row <= rows; ++row) {
        all.columns[0].values.push_back(law.size_ratio);
        all.columns[1].values.push_back(law.alpha);
        all.columns[2].values.push_back(packing);
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            all.columns[3 + c].values.push_back(row < rows ? table.columns[c].values[row]
                                                           : no_estimate);
    }
}

/// The table of every packing with a power law for which `wanted`, below each other.
template <typename Wanted, typename TableOf>
Table stacked(std::span<const NamedMeasurements> packings, std::span<const PackingGroup> groups,
              Wanted&& wanted, TableOf&& table_of) {
    Table all;
    for (const PackingGroup& group : groups)
        if (group.sizes.law && wanted(*group.sizes.law))
            for (const int i : group.members)
                append_rows(all, *group.sizes.law, i, table_of(packings[i].measurements));
    return all;
}

/// At most `most` of the numbers, evenly chosen.
std::set<double> some_of(const std::set<double>& numbers, std::size_t most) {
    const std::vector<double> all(numbers.begin(), numbers.end());
    if (all.size() <= most) return numbers;
    std::set<double> some;
    for (std::size_t k = 0; k < most; ++k) some.insert(all[k * (all.size() - 1) / (most - 1)]);
    return some;
}

struct LargestRatio {
    double size_ratio;
    std::set<double> alphas;
};

LargestRatio largest_ratio_of(std::span<const PackingGroup> groups) {
    LargestRatio largest{*size_ratios_of(groups).rbegin(), {}};
    for (const PowerLaw& law : laws_of(groups))
        if (law.size_ratio == largest.size_ratio) largest.alphas.insert(law.alpha);
    return largest;
}

}  // namespace

Figure volume_fraction_figure(std::span<const PackingGroup> groups) {
    return {
        "volume_fraction",
        "Volume fraction",
        "Volume fraction φ against the exponent α of the cumulative volume; bars: standard error "
        "of the mean over packings. Lines: what the rod model (Farr and Groot, 2009) expects of "
        "these sizes, its one constant such that equal spheres pack to 0.639. Dashed: the "
        "exponent of random Apollonian packings, 0.53.",
        against_alpha(groups) + R"gnuplot(set ylabel "volume fraction φ"
set key outside right top
do for [format in "svg png"] {
    eval(canvas("volume_fraction", format, 720, 460))
    set arrow 1 from 0.53, graph 0 to 0.53, graph 1 nohead linecolor rgb quiet linewidth 0.8 dashtype 2
    plot for [i = 1:n] "rod_model.csv" using "alpha":(of(i, "volume_fraction")) with lines smooth csplines \
         linewidth 1.1 linecolor rgb curve_color(i, n) notitle, \
         for [i = 1:n] data using "alpha":(of(i, "volume_fraction")):(error_of("volume_fraction_error")) \
         with yerrorbars pointtype 7 pointsize 0.1 linewidth 1.2 linecolor rgb curve_color(i, n) notitle, \
         for [i = 1:n] data using "alpha":(of(i, "volume_fraction")) with points pointtype 7 pointsize 0.9 \
         linecolor rgb curve_color(i, n) title label_of(i)
    unset output
}
)gnuplot",
        {groups_data(groups), {"rod_model", rod_table(groups)}}};
}

Figure coordination_figure(std::span<const PackingGroup> groups) {
    return {
        "coordination",
        "Coordination and rattlers",
        "Left: mean number of contacts of all particles (filled) and of the backbone (open); 6 is "
        "what rigidity takes. Right: fraction of the particles that are rattlers.",
        against_alpha(groups) + R"gnuplot(do for [format in "svg png"] {
    eval(canvas("coordination", format, 940, 420))
    set multiplot layout 1,2 margins 0.065,0.985,0.185,0.96 spacing 0.10
    set ylabel "contacts per particle"
    set yrange [0:7]
    set key bottom left
    plot 6 linecolor rgb quiet linewidth 0.8 notitle, \
         for [i = 1:n] data using "alpha":(of(i, "coordination")):(error_of("coordination_error")) with yerrorbars \
         pointtype 7 pointsize 0.1 linewidth 1.1 linecolor rgb curve_color(i, n) notitle, \
         for [i = 1:n] data using "alpha":(of(i, "coordination")) with linespoints pointtype 7 pointsize 0.9 \
         linewidth 1.1 linecolor rgb curve_color(i, n) title label_of(i), \
         for [i = 1:n] data using "alpha":(of(i, "coordination_nr")) with points pointtype 6 pointsize 0.9 \
         linewidth 1.2 linecolor rgb curve_color(i, n) notitle
    set ylabel "fraction of rattlers f_r"
    set yrange [0:1]
    set key top left
    plot for [i = 1:n] data using "alpha":(of(i, "rattler_fraction")):(error_of("rattler_fraction_error")) with yerrorbars \
         pointtype 7 pointsize 0.1 linewidth 1.1 linecolor rgb curve_color(i, n) notitle, \
         for [i = 1:n] data using "alpha":(of(i, "rattler_fraction")) with linespoints pointtype 7 pointsize 0.9 \
         linewidth 1.1 linecolor rgb curve_color(i, n) title label_of(i)
    unset multiplot
    unset output
}
)gnuplot",
        {groups_data(groups)}};
}

Figure backbone_volume_fraction_figure(std::span<const PackingGroup> groups) {
    return {"backbone_volume_fraction",
            "Volume fraction of the backbone",
            "Volume fraction of the backbone alone. Where the curves of different λ fall onto "
            "one, smaller particles add nothing to what bears load. Line: equal spheres, 0.629 "
            "(Monti et al.).",
            against_alpha(groups) + R"gnuplot(set ylabel "volume fraction of the backbone φ_{nr}"
set key outside right top
do for [format in "svg png"] {
    eval(canvas("backbone_volume_fraction", format, 720, 460))
    plot 0.629 linecolor rgb quiet linewidth 0.8 notitle, \
         for [i = 1:n] data using "alpha":(of(i, "volume_fraction_nr")):(error_of("volume_fraction_nr_error")) \
         with yerrorbars pointtype 7 pointsize 0.1 linewidth 1.2 linecolor rgb curve_color(i, n) notitle, \
         for [i = 1:n] data using "alpha":(of(i, "volume_fraction_nr")) with linespoints pointtype 7 pointsize 0.9 \
         linewidth 1.1 linecolor rgb curve_color(i, n) title label_of(i)
    unset output
}
)gnuplot",
            {groups_data(groups)}};
}

Figure larger_by_size_ratio_figure(std::span<const NamedMeasurements> packings,
                                   std::span<const PackingGroup> groups) {
    std::set<double> all_alphas;
    for (const PowerLaw& law : laws_of(groups)) all_alphas.insert(law.alpha);
    const std::set<double> alphas = some_of(all_alphas, 6);
    const Table table = stacked(
        packings, groups, [&](const PowerLaw& law) { return alphas.contains(law.alpha); },
        [](const Measurements& m) { return larger_table(m.backbone_sizes); });
    return {
        "backbone_larger_by_size_ratio",
        "Who is large enough to matter",
        "Fraction F of the backbone’s particles larger than D, over the largest diameter, a curve "
        "a packing. Where curves of different λ fall onto one, the backbone does not know how "
        "small the smallest particles are.",
        script_value("size_ratios", words_of(size_ratios_of(groups))) +
            script_value("alphas", words_of(alphas)) + R"gnuplot(n = words(size_ratios)
panels = words(alphas)
columns = panels < 3 ? panels : 3
rows = (panels + columns - 1)/columns
set logscale x
eval(round_tics("x"))
set yrange [0:1.05]
set ytics 0.2
set key at screen 0.995, screen (rows > 1 ? 0.95 : 0.9) right top
of(i, a, name) = column("size_ratio") == word(size_ratios, i) + 0 && column("alpha") == word(alphas, a) + 0 ? column(name) : NaN
do for [format in "svg png"] {
    eval(canvas("backbone_larger_by_size_ratio", format, columns == 1 ? 640 : columns == 2 ? 860 : 1060, 60 + 280*rows))
    set multiplot layout rows,columns margins columns > 1 ? 0.08 : 0.13,columns == 1 ? 0.80 : columns == 2 ? 0.85 : 0.88,rows > 1 ? 0.115 : 0.20,rows > 1 ? 0.95 : 0.9 spacing 0.06,0.14
    do for [a = 1:panels] {
        set title "α = ".word(alphas, a) offset 0,-0.6
        set xlabel (a > panels - columns ? "D / D_{max}" : "")
        set ylabel (a % columns == 1 || columns == 1 ? "fraction larger F" : "")
        plot for [i = 1:n] "backbone_larger_by_size_ratio.csv" using "scaled_diameter":(of(i, a, "larger_nr")) \
             with lines linewidth 1.2 linecolor rgb curve_color(i, n) \
             title (a == 1 ? "λ = ".word(size_ratios, i) : "")
    }
    unset multiplot
    unset output
}
)gnuplot",
        {{"backbone_larger_by_size_ratio", table}}};
}

Figure onset_figure(std::span<const PackingGroup> groups) {
    return {
        "onset",
        "The smallest size that matters",
        "M, the diameter over the largest at which F first falls below 0.99: smaller particles "
        "hardly bear load. A packing cut off there, with λ* = 1/M, has the same backbone. Thin "
        "lines: 1/λ, below which there are no particles; a point on its line says that all sizes "
        "matter.",
        against_alpha(groups) + R"gnuplot(set ylabel "onset M"
set logscale y
eval(round_tics("y"))
set key outside right top
do for [format in "svg png"] {
    eval(canvas("onset", format, 720, 420))
    plot for [i = 1:n] 1.0/word(size_ratios, i) linecolor rgb curve_color(i, n) linewidth 0.6 notitle, \
         for [i = 1:n] data using "alpha":(of(i, "onset")):(error_of("onset_error")) with yerrorbars pointtype 7 \
         pointsize 0.1 linewidth 1.2 linecolor rgb curve_color(i, n) notitle, \
         for [i = 1:n] data using "alpha":(of(i, "onset")) with linespoints pointtype 7 pointsize 0.9 \
         linewidth 1.1 linecolor rgb curve_color(i, n) title label_of(i)
    unset output
}
)gnuplot",
        {groups_data(groups)}};
}

Figure size_coordination_by_alpha_figure(std::span<const NamedMeasurements> packings,
                                         std::span<const PackingGroup> groups) {
    const auto [ratio, alphas] = largest_ratio_of(groups);
    const Table table = stacked(
        packings, groups,
        [wanted = ratio](const PowerLaw& law) { return law.size_ratio == wanted; },
        [](const Measurements& m) { return jam::table(m.size_coordination); });
    return {"size_coordination_by_alpha",
            "Contacts against size",
            fmt::format("Mean number of contacts beyond three of the backbone’s particles against "
                        "their surface, for λ = {:g}; every packing’s points.",
                        ratio),
            script_value("alphas", words_of(alphas)) + R"gnuplot(n = words(alphas)
of(i, name) = column("alpha") == word(alphas, i) + 0 ? column(name) : NaN
set xlabel "surface (D / D_{max})^2"
set ylabel "excess contacts Z(D) − 3"
set xrange [0:1]
set yrange [0:*]
set key top left
do for [format in "svg png"] {
    eval(canvas("size_coordination_by_alpha", format, 640, 460))
    plot for [i = 1:n] "size_coordination_by_alpha.csv" using "scaled_area":(of(i, "excess_contacts")) \
         with points pointtype 7 pointsize 0.65 linecolor rgb curve_color(i, n) title "α = ".word(alphas, i)
    unset output
}
)gnuplot",
            {{"size_coordination_by_alpha", table}}};
}

Figure backbone_sizes_by_alpha_figure(std::span<const NamedMeasurements> packings,
                                      std::span<const PackingGroup> groups) {
    const auto [ratio, alphas] = largest_ratio_of(groups);
    const Table table = stacked(
        packings, groups,
        [wanted = ratio](const PowerLaw& law) { return law.size_ratio == wanted; },
        [](const Measurements& m) { return density_table(m.backbone_sizes); });
    return {"backbone_sizes_by_alpha",
            "Sizes of the backbone",
            fmt::format("Probability density of the backbone’s diameters for λ = {:g}, a curve a "
                        "packing.",
                        ratio),
            script_value("alphas", words_of(alphas)) + script_value("largest", ratio) +
                R"gnuplot(n = words(alphas)
of(i, name) = column("alpha") == word(alphas, i) + 0 && column(name) > 0 ? column(name) : NaN
set logscale xy
set format y "10^{%T}"
set xrange [1/1.004:largest*1.004]
eval(round_tics("x"))
set xlabel "diameter D"
set ylabel "probability density of the backbone"
set key bottom left
do for [format in "svg png"] {
    eval(canvas("backbone_sizes_by_alpha", format, 640, 460))
    plot for [i = 1:n] "backbone_sizes_by_alpha.csv" using \
         (sqrt(column("diameter_low")*column("diameter_high"))):(of(i, "density_nr")) with lines \
         linewidth 1.2 linecolor rgb curve_color(i, n) title "α = ".word(alphas, i)
    unset output
}
)gnuplot",
            {{"backbone_sizes_by_alpha", table}}};
}

std::vector<Figure> group_figures(std::span<const NamedMeasurements> packings,
                                  std::span<const PackingGroup> groups) {
    if (laws_of(groups).empty()) return {};
    return {volume_fraction_figure(groups),
            coordination_figure(groups),
            backbone_volume_fraction_figure(groups),
            larger_by_size_ratio_figure(packings, groups),
            onset_figure(groups),
            size_coordination_by_alpha_figure(packings, groups),
            backbone_sizes_by_alpha_figure(packings, groups)};
}

}  // namespace jam
