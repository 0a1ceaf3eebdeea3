// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/trade_figure.h"

#include <fmt/format.h>

namespace jam {

static Table points_table(std::span<const TradePoint> points) {
    Table table;
    const auto add = [&](const char* name, auto&& quantity) {
        Column column{name, {}};
        for (const TradePoint& point : points)
            column.values.push_back(static_cast<double>(quantity(point)));
        table.columns.push_back(std::move(column));
    };
    using P = TradePoint;
    add("evaluations", [](const P& p) { return p.evaluations.mean; });
    add("wall_seconds", [](const P& p) { return p.wall_seconds.mean; });
    add("volume_fraction", [](const P& p) { return p.volume_fraction.mean; });
    add("volume_fraction_se", [](const P& p) { return p.volume_fraction.error; });
    add("front_of_volume_fraction", [](const P& p) { return p.front_of_volume_fraction; });
    add("coordination_nr", [](const P& p) { return p.coordination_nr.mean; });
    add("coordination_nr_se", [](const P& p) { return p.coordination_nr.error; });
    add("front_of_coordination", [](const P& p) { return p.front_of_coordination; });
    return table;
}

/// The names as a gnuplot list of words.
static std::string names_of(std::span<const TradePoint> points) {
    std::string names;
    for (const TradePoint& point : points) names += (names.empty() ? "" : " ") + point.name;
    return names;
}

Figure trade_figure(std::span<const TradePoint> points) {
    return {"trade",
            "Speed against accuracy",
            "Error of the volume fraction and of the backbone's coordination against force "
            "evaluations, one point a choice, with standard errors over seeds. The line joins the "
            "choices that no other beats in both; they bear their names, the table has all.",
            script_value("names", names_of(points)) + R"gnuplot(
data = "points.csv"
set datafile missing NaN
label_of(i, mark) = column(mark) > 0 ? word(names, int(i) + 1) : ""
of_front(mark, error) = column(mark) > 0 && column(error) > 0 ? column(error) : NaN
shown(error) = column(error) > 0 ? column(error) : NaN
do for [format in "svg png"] {
    eval(canvas("trade", format, 900, 1000))
    set multiplot layout 2,1 margins 0.11,0.97,0.07,0.985 spacing 0.06
    set logscale xy; set format y "10^{%T}"; set format x "10^{%T}"
    set autoscale xfix; set autoscale yfix; set offsets graph 0.04, graph 0.2, graph 0.06, graph 0.06
    do for [k = 1:2] {
        error = word("volume_fraction coordination_nr", k)
        front = word("front_of_volume_fraction front_of_coordination", k)
        set ylabel (k == 1 ? "error of the volume fraction φ" : "error of Z_{nr}")
        set xlabel (k == 1 ? "" : "force evaluations")
        plot data using "evaluations":(of_front(front, error)) smooth unique \
                 with lines linecolor rgb kind_color(1) linewidth 1.6 notitle, \
             data using "evaluations":(shown(error)):(column(error."_se")) with yerrorbars \
                 linecolor rgb kind_color(2) pointtype 7 pointsize 0.6 notitle, \
             data using "evaluations":(shown(error)):(label_of($0, front)) \
                 with labels left rotate by 30 offset 0.4,0.4 font ",10" noenhanced notitle
    }
    unset multiplot
    unset output
}
)gnuplot",
            {{"points", points_table(points)}}};
}

}  // namespace jam
