// SPDX-License-Identifier: BSD-3-Clause
#include "report/size_figures.h"

#include <fmt/format.h>

#include <cmath>

namespace jam {

Figure cumulative_volume_figure(const CumulativeVolume& volume, const SizePowerLaw& law) {
    const std::string settings = script_value("alpha", law.alpha) +
                                 script_value("smallest", volume.diameters.front()) +
                                 script_value("largest", volume.diameters.back());
    return {
        "cumulative_volume",
        "Cumulative volume fraction",
        fmt::format("Fraction of the particles’ volume in particles no larger than D. Points: "
                    "this packing. Line: the power law of the diameters’ best fit, α = {:.3f} "
                    "± {:.3f} (fractal dimension {:.3f}). A packing whose sizes follow no power "
                    "law leaves the line.",
                    law.alpha, law.error, law.fractal_dimension),
        settings + R"gnuplot(lambda = largest/smallest
analytic(x) = ((1 + x*(lambda - 1))**alpha - 1)/(lambda**alpha - 1)
set xlabel "reduced diameter (D − D_{min}) / (D_{max} − D_{min})"
set ylabel "volume fraction in smaller particles"
set xrange [0:1]
set yrange [0:1]
set key bottom right
set samples 400
do for [format in "svg png"] {
    eval(canvas("cumulative_volume", format, 640, 420))
    plot analytic(x) linecolor rgb kind_color(2) linewidth 1.4 title sprintf("power law, α = %.2f", alpha), \
         "cumulative_volume.csv" using "reduced_diameter":"volume_fraction_below" with points \
         pointtype 6 pointsize 0.6 linecolor rgb kind_color(1) title "packing"
    unset output
}
)gnuplot",
        {{"cumulative_volume", table(volume)}}};
}

Figure pair_sizes_figure(const ContactPairSizes& sizes) {
    const auto [larger, smaller] = sizes.most_probable();
    return {
        "pair_sizes",
        "Which sizes touch",
        fmt::format("Left: probability density that a contact joins particles of diameters D₁ ≥ "
                    "D₂; the most probable pair is D₁ = {:.2f}, D₂ = {:.2f}. Right: the same "
                    "given that there is a particle of diameter D₁. White: no such contact.",
                    larger, smaller),
        script_value("smallest", sizes.bins.edges.front()) +
            script_value("largest", sizes.bins.edges.back()) + R"gnuplot(
set logscale xycb
set xrange [smallest/1.004:largest*1.004]
set yrange [smallest/1.004:largest*1.004]
eval(round_tics("x"))
eval(round_tics("y"))
set size ratio 1
set style fill solid noborder
set xlabel "larger diameter D_1"
set ylabel "smaller diameter D_2" offset 1,0
set format cb "10^{%T}"
unset key
unset grid
middle(a, b) = sqrt(a*b)
positive(x) = x > 0 ? x : NaN
data = "pair_sizes.csv"
do for [format in "svg png"] {
    eval(canvas("pair_sizes", format, 940, 420))
    set multiplot
    do for [panel in "joint conditional"] {
        left = panel eq "joint" ? 0.07 : 0.57
        set lmargin at screen left
        set rmargin at screen left + 0.33
        set bmargin at screen 0.185
        set tmargin at screen 0.90
        set colorbox user origin left + 0.345,0.22 size 0.013,0.58
        set title (panel eq "joint" ? "P_c(D_1, D_2)" : "P_c(D_1, D_2) / P(D_1)")
        plot data using (middle(column("diameter_1_low"), column("diameter_1_high"))): \
                        (middle(column("diameter_2_low"), column("diameter_2_high"))): \
                        "diameter_1_low":"diameter_1_high":"diameter_2_low":"diameter_2_high": \
                        (positive(column(panel))) with boxxyerror linecolor palette
    }
    unset multiplot
    unset output
}
)gnuplot",
        {{"pair_sizes", table(sizes)}}};
}

Figure size_coordination_figure(const SizeCoordination& coordination, const ContactNumbers& numbers,
                                double fit_from) {
    const LinearFit& fit = coordination.fit;
    const std::string line = std::isnan(fit.slope)
                                 ? std::string("There are too few large particles to fit the line.")
                                 : fmt::format("Line: fit to (D/λ)² ≥ {:g}, slope {:.2f} ± {:.2f}.",
                                               fit_from, fit.slope, fit.slope_error);
    return {
        "size_coordination",
        "Contacts against size",
        fmt::format("Left: mean number of contacts beyond the three that hold a particle, for "
                    "particles of the backbone, against their surface. {} Right: the fraction "
                    "of the backbone’s particles with exactly c contacts; {:.1f} % of them have "
                    "3 to 10, which is {:.1f} % of all contacts.",
                    line, 100.0 * numbers.share_of_particles(3, 10),
                    100.0 * numbers.share_of_contacts(3, 10)),
        script_value("slope", fit.slope) + script_value("intercept", fit.intercept) +
            script_value("fit_from", fit_from) + R"gnuplot(
fitted(x) = x >= fit_from ? intercept + slope*x : NaN
set yrange [0:*]
set samples 500
do for [format in "svg png"] {
    eval(canvas("size_coordination", format, 940, 420))
    set multiplot layout 1,2 margins 0.075,0.985,0.185,0.96 spacing 0.115
    set xlabel "surface (D / D_{max})^2"
    set ylabel "excess contacts Z(D) − 3"
    set xrange [0:1]
    set key top left
    plot fitted(x) linecolor rgb kind_color(2) linewidth 1.5 title sprintf("fit, slope %.1f", slope), \
         "size_coordination.csv" using "scaled_area":"excess_contacts":"error" with yerrorbars pointtype 7 \
         pointsize 0.1 linewidth 0.8 linecolor rgb kind_color(1) notitle, \
         "size_coordination.csv" using "scaled_area":"excess_contacts" with points pointtype 7 pointsize 0.75 \
         linecolor rgb kind_color(1) title "backbone"
    set xlabel "contacts c"
    set ylabel "fraction of the backbone with c contacts"
    set xrange [2.4:20.6]
    unset key
    set style fill solid 0.9 noborder
    set boxwidth 0.8
    plot "contact_numbers.csv" using "contacts":"fraction" with boxes linecolor rgb kind_color(1)
    set key
    unset multiplot
    unset output
}
)gnuplot",
        {{"size_coordination", table(coordination)}, {"contact_numbers", table(numbers)}}};
}

Figure backbone_sizes_figure(const BackboneSizes& sizes, const SizePowerLaw& law) {
    return {
        "backbone_sizes",
        "Sizes of the backbone",
        fmt::format("Probability density of the diameters of all particles and of the backbone. "
                    "Dashed: D^{{−β}} with β = {:.3f}, the law of all particles, through either "
                    "curve’s large-diameter tail. Where the backbone’s curve bends away, small "
                    "particles no longer bear load.",
                    law.beta),
        script_value("beta", law.beta) + script_value("smallest", sizes.bins.edges.front()) +
            script_value("largest", sizes.bins.edges.back()) + R"gnuplot(
set logscale xy
set xrange [smallest/1.004:largest*1.004]
eval(round_tics("x"))
set format y "10^{%T}"
set xlabel "diameter D"
set ylabel "probability density"
middle(a, b) = sqrt(a*b)
positive(x) = x > 0 ? x : NaN
data = "backbone_sizes.csv"
# The height of each tail: mean of log(density D^beta) over the upper half of the sizes.
x_middle = "(log(middle(column('diameter_low'), column('diameter_high'))))"
tail(name) = sprintf("stats data using (column('diameter_low') > sqrt(largest) && column('%s') > 0 ? log(column('%s')) + beta*%s : NaN) name '%s_tail' nooutput", name, name, x_middle, name)
eval(tail("density"))
eval(tail("density_nr"))
do for [format in "svg png"] {
    eval(canvas("backbone_sizes", format, 640, 460))
    plot data using (middle(column("diameter_low"), column("diameter_high"))):(positive(column("density"))) \
         with points pointtype 6 pointsize 0.7 linecolor rgb quiet title "all particles", \
         data using (middle(column("diameter_low"), column("diameter_high"))):(positive(column("density_nr"))) \
         with linespoints pointtype 7 pointsize 0.55 linewidth 1.2 linecolor rgb kind_color(1) title "backbone", \
         exp(density_tail_mean)*x**(-beta) linecolor rgb quiet linewidth 1 dashtype 2 notitle, \
         exp(density_nr_tail_mean)*x**(-beta) linecolor rgb kind_color(1) linewidth 1 dashtype 2 \
         title sprintf("D^{−β}, β = %.2f", beta)
    unset output
}
)gnuplot",
        {{"backbone_sizes", density_table(sizes)}}};
}

Figure backbone_larger_figure(const BackboneSizes& sizes) {
    return {"backbone_larger",
            "Who is large enough to matter",
            fmt::format("Fraction F of the backbone’s particles larger than D, D over the largest "
                        "diameter. F first falls below 0.99 at M = {:.4f}: particles smaller than "
                        "that hardly bear load, and a packing with λ* = 1/M = {:.1f} has the same "
                        "backbone.",
                        sizes.onset, sizes.effective_size_ratio),
            script_value("onset", sizes.onset) +
                script_value("smallest", sizes.bins.edges.front() / sizes.bins.edges.back()) +
                R"gnuplot(
set logscale x
eval(round_tics("x"))
set xlabel "D / D_{max}"
set ylabel "fraction larger than D, F"
set xrange [smallest/1.004:1.004]
set yrange [0:1.03]
set key bottom left
do for [format in "svg png"] {
    eval(canvas("backbone_larger", format, 640, 420))
    set arrow 1 from onset, graph 0 to onset, graph 1 nohead linecolor rgb kind_color(2) linewidth 1 dashtype 2
    set label 1 sprintf("M = %.3f", onset) at onset, graph 0.2 offset 0.8,0 textcolor rgb kind_color(2)
    plot "backbone_larger.csv" using "scaled_diameter":"larger_nr" with linespoints pointtype 7 pointsize 0.45 \
         linewidth 1.4 linecolor rgb kind_color(1) notitle
    unset output
}
)gnuplot",
            {{"backbone_larger", larger_table(sizes)}}};
}

}  // namespace jam
