// SPDX-License-Identifier: BSD-3-Clause
#include "report/html_report.h"

#include "report/html_text.h"
#include "report/number_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace jam {

namespace {

using html::escaped;

std::string percent(double fraction) {
    return fmt::format("{:.1f} %", 100.0 * fraction);
}

std::string marked(bool good, const std::string& text) {
    return fmt::format("<span class=\"{}\"><span class=\"mark\">{}</span>{}</span>",
                       good ? "good" : "bad", good ? "✓" : "✗", escaped(text));
}

std::string number_card(const std::string& value, const std::string& label) {
    return fmt::format("<div class=\"number\"><b>{}</b><span>{}</span></div>\n", value, label);
}

std::string header(const std::string& over, const std::string& title, const std::string& lead) {
    return fmt::format(
        "<header>\n<p class=\"over\">{}</p>\n<h1>{}</h1>\n<p class=\"lead\">{}</p>\n"
        "</header>\n",
        escaped(over), escaped(title), escaped(lead));
}

std::string image_element(const PageImage& picture) {
    return fmt::format("<img src=\"{}\" alt=\"{}\">", html::png_data_uri(picture.png),
                       escaped(picture.caption));
}

std::string picture_element(const PageImage& picture) {
    if (picture.png.empty()) return {};
    return fmt::format("<figure class=\"picture\">{}<figcaption>{}</figcaption></figure>\n",
                       image_element(picture), escaped(picture.caption));
}

std::string file_links(const Figure& figure, bool drawn) {
    std::string links;
    for (const Figure::Data& data : figure.data)
        links += fmt::format("<a href=\"{0}.csv\">{0}.csv</a> · ", data.name);
    links += fmt::format("<a href=\"{0}.gp\">{0}.gp</a>", figure.name);
    if (drawn)
        links += fmt::format(" · <a href=\"{0}.svg\">SVG</a> · <a href=\"{0}.png\">PNG</a>",
                             figure.name);
    return "<span class=\"files\">" + links + "</span>";
}

std::string figure_element(const DrawnFigure& drawn, std::size_t number) {
    const Figure& figure = drawn.figure;
    const std::string drawing =
        drawn.svg.empty() ? std::string(
                                "<p class=\"note\">Not drawn: gnuplot is not installed. The "
                                "table and the script are beside this page.</p>")
                          : html::inlined_svg(drawn.svg, figure.name);
    return fmt::format(
        "<figure id=\"{}\">\n{}\n<figcaption><b>Figure {}. {}.</b> {} {}"
        "</figcaption>\n</figure>\n",
        figure.name, drawing, number, escaped(figure.title), html::caption(figure.caption),
        file_links(figure, !drawn.svg.empty()));
}

std::string figures_section(std::span<const DrawnFigure> figures) {
    if (figures.empty()) return {};
    std::string text = "<h2>Figures</h2>\n";
    for (std::size_t k = 0; k < figures.size(); ++k) text += figure_element(figures[k], k + 1);
    return text;
}

std::string key_numbers(const PackingStatistics& s) {
    return "<section class=\"numbers\">\n" +
           number_card(
               fmt::format("{:.4f}", s.volume_fraction),
               fmt::format("volume fraction φ; backbone alone {:.4f}", s.volume_fraction_nr)) +
           number_card(fmt::format("{:.3f}", s.coordination_nr),
                       fmt::format("contacts a backbone particle, Z<sub>nr</sub>; all particles "
                                   "{:.3f}",
                                   s.coordination)) +
           number_card(percent(s.rattler_fraction),
                       fmt::format("rattlers: {} of {} have fewer than {} contacts",
                                   grouped(s.rattler_count), grouped(s.particle_count),
                                   s.rattler_threshold)) +
           number_card(short_number(s.pressure.trace() / 3.0),
                       fmt::format("pressure p; mean overlap {} of the smaller diameter",
                                   short_number(s.mean_overlap))) +
           "</section>\n";
}

std::string verdict_section(const JammingVerdict& verdict) {
    html::TableText content{{"", "Finding", "Limit"}, {}};
    for (const JammingCriterion& criterion : verdict.criteria)
        content.rows.push_back({marked(criterion.holds, criterion.question),
                                escaped(criterion.finding), escaped(criterion.limit)});
    return "<h2>Is it jammed?</h2>\n" + html::table(content, "criteria") +
           "<p class=\"note\">Judged from the packing alone: contacts are pairs that overlap, "
           "forces "
           "are the elastic ones. The limits are those of Monti et al. where they give one.</p>\n";
}

std::string vector_words(const Eigen::RowVector3d& v) {
    return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x(), v.y(), v.z());
}

std::string unheld_words(const PackingStatistics& s) {
    if (s.unheld_count == s.particle_count)
        return "all, if contacts must surround a particle: where the weakest forces do not balance "
               "yet one falls, and others follow";
    return fmt::format(
        "{} ({}), if the contacts must surround a particle", grouped(s.unheld_count),
        percent(static_cast<double>(s.unheld_count) / static_cast<double>(s.particle_count)));
}

std::string numbers_section(const Measurements& m) {
    const PackingStatistics& s = m.statistics;
    const Mat3& p = s.pressure;
    html::TableText content;
    const auto add = [&](const std::string& what, const std::string& value) {
        content.rows.push_back({what, value});
    };
    add("Particles", grouped(s.particle_count));
    add("Size ratio λ", fmt::format("{:.5g}", s.size_ratio));
    if (m.polydisperse())
        add("Exponent of the sizes, best fit",
            fmt::format("α = {:.3f}, β = {:.3f}, fractal dimension {:.3f}, each ± {:.3f}",
                        m.power_law.alpha, m.power_law.beta, m.power_law.fractal_dimension,
                        m.power_law.error));
    add("Volume fraction the rod model expects", fmt::format("{:.4f}", m.rod_fraction));
    add("Contacts", fmt::format("{}; {} in the backbone, isostatic {}", grouped(s.contact_count),
                                grouped(s.contact_count_nr), grouped(s.isostatic_contact_count)));
    add("Rattlers by a stricter rule", unheld_words(s));
    add("Cundall parameter C",
        fmt::format("{}; backbone {}", short_number(s.cundall), short_number(s.cundall_nr)));
    add("Pressure tensor",
        fmt::format("xx {} · yy {} · zz {} · xy {} · xz {} · yz {}", short_number(p(0, 0)),
                    short_number(p(1, 1)), short_number(p(2, 2)), short_number(p(0, 1)),
                    short_number(p(0, 2)), short_number(p(1, 2))));
    add("Overlaps over the smaller diameter",
        fmt::format("mean {}, largest {}", short_number(s.mean_overlap),
                    short_number(s.largest_overlap)));
    if (m.elasticity && m.elasticity->stability.stable)
        add("Stiffness", fmt::format("bulk modulus {}, shear modulus {} (mean of all orientations)",
                                     short_number(m.elasticity->moduli.bulk),
                                     short_number(m.elasticity->moduli.shear)));
    add("Kinetic energy a particle", short_number(s.kinetic_energy_per_particle));
    add("Cell edges", vector_words(s.cell.row(0)) + "<br>" + vector_words(s.cell.row(1)) + "<br>" +
                          vector_words(s.cell.row(2)));
    return "<h2>Numbers</h2>\n" + html::table(content, "facts");
}

std::string provenance_section(const Provenance& provenance) {
    std::string text;
    if (!provenance.creator.empty())
        text += fmt::format("<p>Made by {}.</p>\n", escaped(provenance.creator));
    if (!provenance.command_line.empty())
        text += fmt::format("<pre>{}</pre>\n", escaped(provenance.command_line));
    if (!provenance.scene.empty())
        text += fmt::format("<details><summary>The scene</summary>\n<pre>{}</pre></details>\n",
                            escaped(provenance.scene));
    return text.empty() ? text : "<h2>Where it comes from</h2>\n" + text;
}

std::string verdict_line(const JammingVerdict& verdict) {
    return fmt::format("<p class=\"verdict\">{}</p>\n",
                       marked(verdict.jammed(), verdict.sentence()));
}

std::string groups_section(std::span<const PackingGroup> groups) {
    html::TableText content{
        {"Sizes", "Packings", "φ", "φ<sub>nr</sub>", "Z", "Z<sub>nr</sub>", "f<sub>r</sub>", "M"},
        {}};
    const auto words = [](const Estimate& e) { return with_error(e.value, e.error); };
    for (const PackingGroup& g : groups)
        content.rows.push_back({escaped(g.sizes.words), fmt::format("{}", g.members.size()),
                                words(g.volume_fraction), words(g.volume_fraction_nr),
                                words(g.coordination), words(g.coordination_nr),
                                words(g.rattler_fraction), words(g.onset)});
    return "<h2>Averages</h2>\n" + html::table(content, "figures-of") +
           "<p class=\"note\">In parentheses the standard error of the mean over packings, in "
           "units "
           "of the last digit. φ volume fraction, Z contacts a particle, f<sub>r</sub> fraction of "
           "rattlers, M onset of the sizes that bear load over the largest; nr: the backbone "
           "alone, "
           "without rattlers.</p>\n";
}

std::string gallery(std::span<const PageImage> pictures) {
    if (pictures.empty()) return {};
    std::string text = "<section class=\"gallery\">\n";
    for (const PageImage& picture : pictures)
        text += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                            image_element(picture), escaped(picture.caption));
    return text + "</section>\n";
}

std::vector<std::string> packing_row(const NamedMeasurements& packing) {
    const PackingStatistics& s = packing.measurements.statistics;
    const bool jammed = judge(packing.measurements).jammed();
    return {escaped(packing.name),
            escaped(packing.sizes.words),
            grouped(s.particle_count),
            fmt::format("{:.4f}", s.volume_fraction),
            fmt::format("{:.3f}", s.coordination_nr),
            short_number(s.cundall),
            marked(jammed, jammed ? "jammed" : "not")};
}

/// In the order of the groups.
std::string packings_section(std::span<const NamedMeasurements> packings,
                             std::span<const PackingGroup> groups) {
    html::TableText content{
        {"Packing", "Sizes", "Particles", "φ", "Z<sub>nr</sub>", "C", "Verdict"}, {}};
    for (const PackingGroup& group : groups)
        for (const int i : group.members) content.rows.push_back(packing_row(packings[i]));
    return "<h2>The packings</h2>\n" + html::table(content, "facts");
}

}  // namespace

std::string packing_page(const NamedMeasurements& packing, const Provenance& provenance,
                         const PageImage& picture, std::span<const DrawnFigure> figures) {
    const Measurements& m = packing.measurements;
    const JammingVerdict verdict = judge(m);
    const std::string lead =
        fmt::format("{} particles, {}", grouped(m.statistics.particle_count), packing.sizes.words);
    return html::page(packing.name, header("Packing report", packing.name, lead) +
                                        verdict_line(verdict) + picture_element(picture) +
                                        key_numbers(m.statistics) + verdict_section(verdict) +
                                        numbers_section(m) + figures_section(figures) +
                                        provenance_section(provenance));
}

std::string packings_page(std::span<const NamedMeasurements> packings,
                          std::span<const PackingGroup> groups, std::span<const PageImage> pictures,
                          std::span<const DrawnFigure> figures) {
    const auto jammed = std::ranges::count_if(
        packings, [](const NamedMeasurements& p) { return judge(p.measurements).jammed(); });
    const std::string title = fmt::format("{} packings", packings.size());
    const std::string lead =
        fmt::format("{} of sizes; {} of {} are jammed",
                    groups.size() == 1 ? "one kind" : fmt::format("{} kinds", groups.size()),
                    jammed, packings.size());
    return html::page(title, header("Packing report", title, lead) + gallery(pictures) +
                                 groups_section(groups) + figures_section(figures) +
                                 packings_section(packings, groups));
}

}  // namespace jam
