// SPDX-License-Identifier: BSD-3-Clause
#include "report/history_figure.h"

#include <fmt/format.h>

namespace jam {

Figure history_figure(const Table& history, double applied_pressure) {
    return {
        "history",
        "The run",
        "Volume fraction, coordination, and what is out of balance, against simulated time. In a "
        "jammed packing the upper curves have stopped and the lowest ones have come down to "
        "where the numbers of the computer end.",
        script_value("applied_pressure", applied_pressure) +
            script_value("last_all", history.columns[2].values.back()) +
            script_value("last_backbone", history.columns[3].values.back()) + R"gnuplot(
data = "history.csv"
stats data using "time" name "time" nooutput
power = time_max > 0 ? 3*int(floor(log10(time_max)/3)) : 0
unit = 10.0**power
time_label = power == 0 ? "time (√(M_{min}/k))" : sprintf("time (10^{%d} √(M_{min}/k))", power)
do for [format in "svg png"] {
    eval(canvas("history", format, 640, 720))
    set multiplot layout 3,1 margins 0.15,0.97,0.095,0.985 spacing 0.035
    set format x ""; unset xlabel
    set ylabel "volume fraction φ"
    plot data using (column("time")/unit):"volume_fraction" with lines linecolor rgb kind_color(1) linewidth 1.6 notitle
    set ylabel "contacts per particle"
    set yrange [0:7]
    set label 1 "Z_{nr}, backbone" at graph 0.985, first last_backbone right offset 0,-0.9 textcolor rgb kind_color(1)
    set label 2 "Z, all" at graph 0.985, first last_all right offset 0,-0.9 textcolor rgb kind_color(2)
    plot 6 linecolor rgb quiet linewidth 0.8 notitle, \
         data using (column("time")/unit):"coordination_nr" with lines linecolor rgb kind_color(1) linewidth 1.6 \
         notitle, \
         data using (column("time")/unit):"coordination" with lines linecolor rgb kind_color(2) linewidth 1.6 \
         notitle
    unset label 1; unset label 2; set yrange [*:*]
    set format x "%g"; set xlabel time_label
    set ylabel "imbalance"
    set logscale y; set format y "10^{%T}"
    set key top right
    plot data using (column("time")/unit):"cundall" with lines linecolor rgb kind_color(3) linewidth 1.6 \
         title "Cundall parameter C", \
         data using (column("time")/unit):(applied_pressure > 0 ? abs(column("pressure")/applied_pressure - 1) : NaN) \
         with lines linecolor rgb kind_color(4) linewidth 1.6 title (applied_pressure > 0 ? "|p / p_a − 1|" : "")
    unset logscale y; set format y "%h"
    unset multiplot
    unset output
}
)gnuplot",
        {{"history", history}}};
}

}  // namespace jam
