// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/statistics_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace jam::apps {

namespace {

using nlohmann::ordered_json;

ordered_json rows_of(const Mat3& matrix) {
    ordered_json rows = ordered_json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({matrix(i, 0), matrix(i, 1), matrix(i, 2)});
    return rows;
}

/// 1234567 as 1,234,567.
std::string grouped(Count number) {
    if (number < 1000) return fmt::format("{}", number);
    return fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

std::string number_or_dash(double number) {
    return std::isnan(number) ? "-" : fmt::format("{:.3g}", number);
}

/// A line of the table: what it is, its value, and what to know about it.
std::string line(std::string_view label, const std::string& value, const std::string& note = "") {
    if (note.empty()) return fmt::format("  {:<22}{}\n", label, value);
    return fmt::format("  {:<22}{:<14}{}\n", label, value, note);
}

/// The stricter test speaks of forces in balance: where the weakest are not, one particle after the
/// other falls.
std::string unheld_words(const PackingStatistics& s) {
    if (s.unheld_count < s.particle_count)
        return fmt::format("{} by the stricter test: not held from all sides",
                           grouped(s.unheld_count));
    return "the stricter test leaves none: one leans to one side, and takes the next with it";
}

std::string contacts_lines(const PackingStatistics& s) {
    const auto backbone = s.particle_count - s.rattler_count;
    std::string text;
    text += line(
        "contacts", grouped(s.contact_count),
        fmt::format("{} in the backbone, {:+} against isostatic {}", grouped(s.contact_count_nr),
                    s.excess_contact_count(), grouped(s.isostatic_contact_count)));
    text += line("coordination", fmt::format("{:.4f}", s.coordination),
                 fmt::format("{:.4f} in the backbone", s.coordination_nr));
    text += line("rattlers", fmt::format("{:.2f} %", 100.0 * s.rattler_fraction),
                 fmt::format("{} with fewer than {} contacts; the backbone has {}",
                             grouped(s.rattler_count), s.rattler_threshold, grouped(backbone)));
    text += line("", "", unheld_words(s));
    text += line("overlap", fmt::format("{:.3g}", s.mean_overlap),
                 fmt::format("of the smaller diameter; largest {:.3g}", s.largest_overlap));
    return text;
}

std::string stress_lines(const PackingStatistics& s) {
    const Mat3& p = s.pressure;
    std::string text;
    text += line("pressure", fmt::format("{:.6g}", p.trace() / 3.0), "static");
    text += line("", fmt::format("xx {:<14.6g}yy {:<14.6g}zz {:.6g}", p(0, 0), p(1, 1), p(2, 2)));
    text += line("", fmt::format("xy {:<14.3g}xz {:<14.3g}yz {:.3g}", p(0, 1), p(0, 2), p(1, 2)));
    text += line("Cundall parameter", number_or_dash(s.cundall),
                 fmt::format("{} in the backbone", number_or_dash(s.cundall_nr)));
    text += line("kinetic energy", fmt::format("{:.3g}", s.kinetic_energy_per_particle),
                 "per particle");
    return text;
}

std::string cell_lines(const Mat3& cell) {
    constexpr std::array names = {"a", "b", "c"};
    std::string text;
    for (int k = 0; k < 3; ++k)
        text += line(k == 0 ? "cell" : "",
                     fmt::format("{}  {:12.6f}{:12.6f}{:12.6f}", names[static_cast<unsigned>(k)],
                                 cell(k, 0), cell(k, 1), cell(k, 2)));
    return text;
}

ordered_json number_rows(const Mat6& matrix) {
    ordered_json rows = ordered_json::array();
    for (int a = 0; a < strain_count; ++a) {
        ordered_json row = ordered_json::array();
        for (int b = 0; b < strain_count; ++b) row.push_back(matrix(a, b));
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

ordered_json statistics_json(const PackingStatistics& s) {
    ordered_json json;
    json["particle_count"] = s.particle_count;
    json["size_ratio"] = s.size_ratio;
    json["volume_fraction"] = s.volume_fraction;
    json["volume_fraction_nr"] = s.volume_fraction_nr;
    json["coordination"] = s.coordination;
    json["coordination_nr"] = s.coordination_nr;
    json["rattler_fraction"] = s.rattler_fraction;
    json["contact_count"] = s.contact_count;
    json["cundall"] = s.cundall;
    json["pressure"] = rows_of(s.pressure);
    json["cell"] = rows_of(s.cell);
    json["kinetic_energy_per_particle"] = s.kinetic_energy_per_particle;
    json["rattler_threshold"] = s.rattler_threshold;
    json["rattler_count"] = s.rattler_count;
    json["unheld_count"] = s.unheld_count;
    json["contact_count_nr"] = s.contact_count_nr;
    json["isostatic_contact_count"] = s.isostatic_contact_count;
    json["excess_contact_count"] = s.excess_contact_count();
    json["cundall_nr"] = s.cundall_nr;
    json["largest_overlap"] = s.largest_overlap;
    json["mean_overlap"] = s.mean_overlap;
    return json;
}

std::string statistics_table(const PackingStatistics& s, const std::string& name) {
    std::string text = name + "\n";
    text += line("particles", grouped(s.particle_count),
                 fmt::format("size ratio {:.6g}", s.size_ratio));
    text += line("volume fraction", fmt::format("{:.5f}", s.volume_fraction),
                 fmt::format("{:.5f} without rattlers", s.volume_fraction_nr));
    return text + contacts_lines(s) + stress_lines(s) + cell_lines(s.cell);
}

ordered_json elasticity_json(const Elasticity& e) {
    ordered_json json;
    json["particle_count"] = e.particle_count;
    json["pressure"] = e.pressure;
    json["stable"] = e.stability.stable;
    json["smallest_eigenvalue"] = e.stability.smallest_eigenvalue;
    json["bulk_modulus"] = e.moduli.bulk;
    json["shear_modulus"] = e.moduli.shear;
    json["stiffness"] = number_rows(e.moduli.stiffness);
    return json;
}

std::string elasticity_table(const Elasticity& e) {
    if (e.particle_count == 0)
        return line("elasticity", "-", "no particle is held by four contacts");
    std::string text =
        line("stable", e.stability.stable ? "yes" : "no",
             fmt::format("smallest eigenvalue {:.3g} of {} particles that four hold and the cell",
                         e.stability.smallest_eigenvalue, grouped(e.particle_count)));
    text += line("bulk modulus", number_or_dash(e.moduli.bulk),
                 fmt::format("shear modulus {}", number_or_dash(e.moduli.shear)));
    return text;
}

}  // namespace jam::apps
