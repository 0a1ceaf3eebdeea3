// SPDX-License-Identifier: BSD-3-Clause
#include "report/history_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

namespace jam {

namespace {

std::span<const double> values_of(const Table& table, std::string_view name) {
    return std::ranges::find(table.columns, name, &Column::name)->values;
}

/// The step from which on simulated time stands still: where a quasi-static run begins to
/// relax. Not a number for a run that moves to its end.
double first_step_of_relaxation(const Table& history) {
    const std::span<const double> times = values_of(history, "time");
    const auto still = std::ranges::find(times, times.back()) - times.begin();
    const bool relaxes = still + 1 < std::ssize(times);
    return relaxes ? values_of(history, "step")[static_cast<std::size_t>(still)] : std::nan("");
}

/// Script lines with the lowest and the highest pressure to be drawn.
std::string pressure_range(const Table& history, double applied_pressure) {
    double low = applied_pressure > 0.0 ? applied_pressure : std::numeric_limits<double>::max();
    double high = applied_pressure;
    for (const double pressure : values_of(history, "pressure")) {
        if (pressure > 0.0) low = std::min(low, pressure);
        if (pressure > 0.0) high = std::max(high, pressure);
    }
    if (high <= 0.0) low = high = 1.0;
    return script_value("lowest_pressure", low) + script_value("highest_pressure", high);
}

std::string caption(bool relaxes) {
    std::string text =
        "Volume fraction, contacts, pressure and what is out of balance, against the steps; a step "
        "evaluates the forces once. ";
    if (relaxes)
        text +=
            "Left of the broken line the packing is compacted by inertia, right of it relaxed "
            "under a pressure that descends to the applied one. ";
    return text +
           "In a jammed packing all curves have stopped, the backbone has as many contacts as "
           "rigidity takes, and C and the error of the pressure have come down.";
}

}  // namespace

Figure history_figure(const Table& history, double applied_pressure) {
    const double relaxation = first_step_of_relaxation(history);
    return {"history",
            "The run",
            caption(!std::isnan(relaxation)),
            script_value("applied_pressure", applied_pressure) +
                script_value("relaxation", relaxation) + pressure_range(history, applied_pressure) +
                script_value("last_all", values_of(history, "coordination").back()) +
                script_value("last_backbone", values_of(history, "coordination_nr").back()) +
                R"gnuplot(
data = "history.csv"
stats data using "step" name "step" nooutput
power = step_max > 0 ? 3*int(floor(log10(step_max)/3)) : 0
unit = 10.0**power
step_label = power == 0 ? "steps" : sprintf("steps (10^{%d})", power)
positive(x) = x > 0 ? x : NaN
applied(x) = applied_pressure > 0 ? applied_pressure : NaN
do for [format in "svg png"] {
    eval(canvas("history", format, 640, 860))
    set multiplot layout 4,1 margins 0.175,0.97,0.08,0.985 spacing 0.03
    if (relaxation == relaxation) {
        set arrow 1 from relaxation/unit, graph 0 to relaxation/unit, graph 1 nohead linecolor rgb quiet linewidth 0.8 dashtype 2
    }
    set xrange [0:step_max > 0 ? step_max/unit : 1]
    set format x ""; unset xlabel
    set ylabel "volume fraction φ"
    plot data using (column("step")/unit):"volume_fraction" with lines linecolor rgb kind_color(1) linewidth 1.6 notitle
    set ylabel "contacts per particle"
    set yrange [*:*]; set offsets 0,0,0.6,0.2
    set label 1 "Z_{nr}, backbone" at graph 0.985, first last_backbone right offset 0,0.8 textcolor rgb kind_color(1)
    set label 2 "Z, all" at graph 0.985, first last_all right offset 0,-0.9 textcolor rgb kind_color(2)
    plot 6 linecolor rgb quiet linewidth 0.8 notitle, \
         data using (column("step")/unit):"coordination_nr" with lines linecolor rgb kind_color(1) linewidth 1.6 \
         notitle, \
         data using (column("step")/unit):"coordination" with lines linecolor rgb kind_color(2) linewidth 1.6 \
         notitle
    unset label 1; unset label 2; set offsets 0,0,0,0
    set yrange [lowest_pressure/1.6:highest_pressure*2.5]
    set logscale y; set format y "10^{%T}"
    set key top right
    set ylabel "pressure p"
    plot applied(x) linecolor rgb quiet linewidth 1 dashtype 2 title (applied_pressure > 0 ? "applied" : ""), \
         data using (column("step")/unit):(positive(column("pressure"))) with lines linecolor rgb kind_color(1) \
         linewidth 1.6 notitle
    set format x "%g"; set xlabel step_label
    set yrange [*:*]; set key bottom left
    set ylabel "imbalance"
    plot data using (column("step")/unit):(positive(column("cundall"))) with lines linecolor rgb kind_color(3) \
         linewidth 1.6 title "Cundall parameter C", \
         data using (column("step")/unit):(applied_pressure > 0 ? positive(abs(column("pressure")/applied_pressure - 1)) : NaN) \
         with lines linecolor rgb kind_color(4) linewidth 1.6 title (applied_pressure > 0 ? "|p / p_a − 1|" : "")
    unset logscale y; set format y "%h"
    unset multiplot
    unset output
}
)gnuplot",
            {{"history", history}}};
}

}  // namespace jam
