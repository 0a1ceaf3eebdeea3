// SPDX-License-Identifier: BSD-3-Clause
#include "report/packing_figures.h"

#include "report/history_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

/// An exponent with its error in a sentence, or that there is none.
std::string exponent_words(const char* law, const char* symbol, double value, double error) {
    if (std::isnan(value)) return "there are too few of them here to tell";
    return fmt::format("here they follow {} with {} = {:.2f} ± {:.2f}", law, symbol, value, error);
}

/// What makes height x^exponent hold as many values as the fit was made of; `density` times a bin's
/// width is counts over some number that is the same for all bins.
double law_height(const PowerLawFit& fit, const Bins& bins, std::span<const double> density,
                  std::span<const Count> counts) {
    double counted = 0.0;
    double share = 0.0;
    for (int bin = 0; bin < bins.count(); ++bin) {
        counted += static_cast<double>(counts[bin]);
        share += density[bin] * bins.width(bin);
    }
    const double k = fit.exponent + 1.0;
    const double integral = (std::pow(fit.high, k) - std::pow(fit.low, k)) / k;
    return static_cast<double>(fit.value_count) * share / (counted * integral);
}

/// Bins with fewer are not drawn: their errors are as large as they are.
constexpr Count fewest_in_bin = 3;

bool worth_drawing(std::span<const Count> counts) {
    return std::ranges::any_of(counts, [](Count count) { return count >= fewest_in_bin; });
}

}  // namespace

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

Figure forces_figure(const ForceDistribution& forces) {
    const PowerLawFit& fit = forces.small_forces;
    return {
        "forces",
        "Contact forces",
        fmt::format("Probability density of the contact forces in the backbone, over their mean. "
                    "Near jamming small forces should follow f^{{θ}} with θ = 0.42, or 0.17 where "
                    "particles are loosely held (Charbonneau et al., 2015); {}.",
                    exponent_words("f^{θ}", "θ", fit.exponent, fit.error)),
        script_value("fewest", fewest_in_bin) + script_value("theta", fit.exponent) +
            script_value("low", fit.low) + script_value("high", fit.high) +
            script_value("height",
                         law_height(fit, forces.bins, forces.density, forces.contact_counts)) +
            R"gnuplot(
set logscale xy
set format xy "10^{%T}"
set xlabel "contact force f / ⟨f⟩"
set ylabel "probability density"
set key bottom center
middle(a, b) = sqrt(a*b)
seen(density, count) = count >= fewest ? density : NaN
data = "forces.csv"
law(x) = x >= low && x <= high ? height*x**theta : NaN
set samples 400
do for [format in "svg png"] {
    eval(canvas("forces", format, 640, 420))
    plot data using (middle(column("force_low"), column("force_high"))):(seen(column("density"), column("contacts"))): \
         (column("density")/sqrt(column("contacts"))) \
         with yerrorbars pointtype 7 pointsize 0.55 linewidth 0.8 linecolor rgb kind_color(1) title "contacts", \
         law(x) linecolor rgb kind_color(2) linewidth 1.6 title (low < high ? sprintf("f^{θ}, θ = %.2f", theta) : "")
    unset output
}
)gnuplot",
        {{"forces", table(forces)}}};
}

Figure gaps_figure(const GapDistribution& gaps) {
    const PowerLawFit& fit = gaps.small_gaps;
    return {
        "gaps",
        "Gaps between particles",
        fmt::format("Pairs of backbone particles that do not touch, a particle and unit of gap "
                    "h = 2r/(D₁ + D₂) − 1. Near jamming small gaps should follow h^{{−γ}} with γ = "
                    "0.41 (Charbonneau et al., 2015); {}.",
                    exponent_words("h^{−γ}", "γ", -fit.exponent, fit.error)),
        script_value("fewest", fewest_in_bin) + script_value("exponent", fit.exponent) +
            script_value("low", fit.low) + script_value("high", fit.high) +
            script_value("height", law_height(fit, gaps.bins, gaps.density, gaps.pair_counts)) +
            R"gnuplot(
set logscale xy
set format xy "10^{%T}"
set xlabel "gap h"
set ylabel "pairs per particle and unit of gap"
set key top right
middle(a, b) = sqrt(a*b)
seen(density, count) = count >= fewest ? density : NaN
data = "gaps.csv"
law(x) = x >= low && x <= high ? height*x**exponent : NaN
set samples 400
do for [format in "svg png"] {
    eval(canvas("gaps", format, 640, 420))
    plot data using (middle(column("gap_low"), column("gap_high"))):(seen(column("density"), column("pairs"))): \
         (column("density")/sqrt(column("pairs"))) \
         with yerrorbars pointtype 7 pointsize 0.55 linewidth 0.8 linecolor rgb kind_color(1) title "pairs", \
         law(x) linecolor rgb kind_color(2) linewidth 1.6 title (low < high ? sprintf("h^{−γ}, γ = %.2f", -exponent) : "")
    unset output
}
)gnuplot",
        {{"gaps", table(gaps)}}};
}

Figure radial_figure(const RadialDistribution& radial) {
    std::string names;
    const int last = static_cast<int>(radial.class_sizes.size()) - 1;
    for (const RadialDistribution::Pair& pair : radial.pairs) {
        const bool alike = pair.class_1 == pair.class_2;
        if (alike || (pair.class_1 == 0 && pair.class_2 == last))
            names += fmt::format("{}g_{}_{}", names.empty() ? "" : " ", pair.class_1 + 1,
                                 pair.class_2 + 1);
    }
    std::string classes;
    for (std::size_t k = 0; k + 1 < radial.class_bounds.size(); ++k)
        classes += fmt::format("{}{}: D {:.3g} to {:.3g}", k == 0 ? "" : "; ", k + 1,
                               radial.class_bounds[k], radial.class_bounds[k + 1]);
    return {
        "radial",
        "Pair correlation",
        fmt::format("How much more often than at random two particles are found at the distance "
                    "r, over the distance at which they would touch. Size classes — {}.",
                    classes),
        script_value("pairs", names) + R"gnuplot(
set xlabel "scaled distance 2r / (D_1 + D_2)"
set ylabel "pair correlation g"
set logscale y
set xrange [0.8:2.5]
set yrange [0.1:*]
set key top right
label_of(name) = sprintf("classes %s and %s", name[3:3], name[5:5])
do for [format in "svg png"] {
    eval(canvas("radial", format, 640, 420))
    plot for [i = 1:words(pairs)] "radial.csv" using (0.5*(column("distance_low") + column("distance_high"))): \
         (column(word(pairs, i)) > 0 ? column(word(pairs, i)) : NaN) with lines linewidth 1.3 \
         linecolor rgb curve_color(i, words(pairs)) \
         title (words(pairs) > 1 ? label_of(word(pairs, i)) : "")
    unset output
}
)gnuplot",
        {{"radial", table(radial)}}};
}

std::vector<Figure> packing_figures(const Measurements& m, const Table& history) {
    std::vector<Figure> figures;
    if (!history.columns.empty())
        figures.push_back(history_figure(history, m.applied_pressure.trace() / 3.0));
    const bool has_backbone = m.statistics.rattler_count < m.statistics.particle_count;
    if (m.polydisperse()) {
        figures.push_back(cumulative_volume_figure(m.cumulative_volume, m.power_law));
        if (has_backbone) {
            figures.push_back(pair_sizes_figure(m.pair_sizes));
            figures.push_back(size_coordination_figure(m.size_coordination, m.contact_numbers,
                                                       SizeCoordinationSettings{}.fit_from));
            figures.push_back(backbone_sizes_figure(m.backbone_sizes, m.power_law));
            figures.push_back(backbone_larger_figure(m.backbone_sizes));
        }
    }
    if (worth_drawing(m.forces.contact_counts)) figures.push_back(forces_figure(m.forces));
    if (worth_drawing(m.gaps.pair_counts)) figures.push_back(gaps_figure(m.gaps));
    figures.push_back(radial_figure(m.radial));
    return figures;
}

}  // namespace jam
