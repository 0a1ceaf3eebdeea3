// SPDX-License-Identifier: BSD-3-Clause
#include "report/pair_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

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

/// A density over logarithmic bins: how its table and its axes name what is in it.
struct DensityNames {
    std::string figure;    ///< of the table, too
    std::string quantity;  ///< columns QUANTITY_low and QUANTITY_high
    std::string counted;   ///< column of the numbers behind each bin
    std::string x_label, y_label, key, law;
};

/// Points with the errors of their counts, and the power law that was fitted to the small values.
std::string density_script(const DensityNames& names, const PowerLawFit& fit, double height) {
    return script_value("figure", names.figure) +
           script_value("low_edge", names.quantity + "_low") +
           script_value("high_edge", names.quantity + "_high") +
           script_value("counted", names.counted) + script_value("x_name", names.x_label) +
           script_value("y_name", names.y_label) + script_value("law_name", names.law) +
           script_value("fewest", fewest_in_bin) + script_value("exponent", fit.exponent) +
           script_value("low", fit.low) + script_value("high", fit.high) +
           script_value("height", height) + "set key " + names.key + R"gnuplot(
set logscale xy
set format xy "10^{%T}"
set xlabel x_name
set ylabel y_name
middle(a, b) = sqrt(a*b)
seen(value, count) = count >= fewest ? value : NaN
data = figure.".csv"
law(x) = x >= low && x <= high ? height*x**exponent : NaN
set samples 400
do for [format in "svg png"] {
    eval(canvas(figure, format, 640, 420))
    plot data using (seen(middle(column(low_edge), column(high_edge)), column(counted))):"density": \
         (column("density")/sqrt(column(counted))) \
         with yerrorbars pointtype 7 pointsize 0.55 linewidth 0.8 linecolor rgb kind_color(1) title counted, \
         law(x) linecolor rgb kind_color(2) linewidth 1.6 title (low < high ? law_name : "")
    unset output
}
)gnuplot";
}

}  // namespace

bool worth_drawing(std::span<const Count> counts) {
    return std::ranges::any_of(counts, [](Count count) { return count >= fewest_in_bin; });
}

Figure forces_figure(const ForceDistribution& forces) {
    const PowerLawFit& fit = forces.small_forces;
    const DensityNames names = {"forces",
                                "force",
                                "contacts",
                                "contact force f / ⟨f⟩",
                                "probability density",
                                "bottom center",
                                fmt::format("f^{{θ}}, θ = {:.2f}", fit.exponent)};
    return {
        names.figure,
        "Contact forces",
        fmt::format("Probability density of the contact forces in the backbone, over their mean. "
                    "Near jamming small forces should follow f^{{θ}} with θ = 0.42, or 0.17 where "
                    "particles are loosely held (Charbonneau et al., 2015); {}.",
                    exponent_words("f^{θ}", "θ", fit.exponent, fit.error)),
        density_script(names, fit,
                       law_height(fit, forces.bins, forces.density, forces.contact_counts)),
        {{names.figure, table(forces)}}};
}

Figure gaps_figure(const GapDistribution& gaps) {
    const PowerLawFit& fit = gaps.small_gaps;
    const DensityNames names = {"gaps",
                                "gap",
                                "pairs",
                                "gap h",
                                "pairs per particle and unit of gap",
                                "top right",
                                fmt::format("h^{{−γ}}, γ = {:.2f}", -fit.exponent)};
    return {
        names.figure,
        "Gaps between particles",
        fmt::format("Pairs of backbone particles that do not touch, a particle and unit of gap "
                    "h = 2r/(D₁ + D₂) − 1. Near jamming small gaps should follow h^{{−γ}} with γ = "
                    "0.41 (Charbonneau et al., 2015); {}.",
                    exponent_words("h^{−γ}", "γ", -fit.exponent, fit.error)),
        density_script(names, fit, law_height(fit, gaps.bins, gaps.density, gaps.pair_counts)),
        {{names.figure, table(gaps)}}};
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

}  // namespace jam
