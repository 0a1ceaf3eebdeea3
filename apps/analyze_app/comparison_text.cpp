// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/comparison_text.h"

#include <fmt/format.h>

#include <cmath>

namespace jam::apps {

namespace {

using nlohmann::ordered_json;

ordered_json estimate_json(const Estimate& estimate) {
    return {{"value", estimate.value},
            {"error", estimate.error},
            {"low", estimate.low},
            {"high", estimate.high}};
}

std::string estimate_text(const Estimate& estimate) {
    if (std::isnan(estimate.error)) return fmt::format("{:.6g}", estimate.value);
    return fmt::format("{:.6g} ± {:.2g}", estimate.value, estimate.error);
}

std::string chance_text(double p_value) {
    if (std::isnan(p_value)) return "-";
    return p_value < 1e-4 ? "< 0.0001" : fmt::format("{:.4f}", p_value);
}

std::string packings_text(Count count) {
    return count == 1 ? "1 packing" : fmt::format("{} packings", count);
}

}  // namespace

ordered_json comparison_json(const PackingComparison& comparison,
                             const std::vector<std::string>& paths_a,
                             const std::vector<std::string>& paths_b) {
    ordered_json json;
    json["a"] = paths_a;
    json["b"] = paths_b;
    for (const NumberComparison& number : comparison.numbers)
        json["numbers"][number.name] = {{"a", estimate_json(number.a)},
                                        {"b", estimate_json(number.b)},
                                        {"difference", number.difference},
                                        {"p_value", number.p_value}};
    json["distributions"] = ordered_json::object();
    for (const DistributionComparison& distribution : comparison.distributions)
        json["distributions"][distribution.name] = {{"distance", distribution.difference.distance},
                                                    {"p_value", distribution.difference.p_value},
                                                    {"count_a", distribution.count_a},
                                                    {"count_b", distribution.count_b}};
    return json;
}

std::string comparison_table(const PackingComparison& comparison, const std::string& name_a,
                             const std::string& name_b) {
    const NumberComparison& first = comparison.numbers.front();
    std::string text =
        fmt::format("A  {} ({})\nB  {} ({})\n\n", name_a, packings_text(first.a.count), name_b,
                    packings_text(first.b.count));
    constexpr auto row = "{:<29}{:<23}{:<23}{:<15}{}\n";
    text += fmt::format(row, "mean over packings", "A", "B", "B - A", "p");
    for (const NumberComparison& n : comparison.numbers)
        text += fmt::format(row, n.name, estimate_text(n.a), estimate_text(n.b),
                            fmt::format("{:+.4g}", n.difference), chance_text(n.p_value));
    text += fmt::format("\n{:<29}{:<23}{:<23}{:<15}{}\n", "distribution", "values of A",
                        "values of B", "distance", "p");
    for (const DistributionComparison& d : comparison.distributions)
        text += fmt::format(row, d.name, d.count_a, d.count_b,
                            fmt::format("{:.4g}", d.difference.distance),
                            chance_text(d.difference.p_value));
    text +=
        "\np: how often chance alone would make a difference at least as large. Means need two "
        "packings on a side.\n";
    return text;
}

}  // namespace jam::apps
