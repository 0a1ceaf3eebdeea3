// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/verdict.h"

#include "core/check.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

using Json = nlohmann::ordered_json;

bool Verdict::converged() const {
    return !criteria.empty() &&
           std::ranges::all_of(criteria, [](const Criterion& one) { return one.holds; });
}

std::string to_json(const Verdict& verdict) {
    Json criteria = Json::array();
    for (const Criterion& one : verdict.criteria)
        criteria.push_back({{"name", one.name},
                            {"value", one.value},
                            {"tolerance", one.tolerance},
                            {"holds", one.holds}});
    return Json{{"converged", verdict.converged()}, {"criteria", criteria}}.dump();
}

Verdict verdict_from_json(const std::string& text) {
    Verdict verdict;
    try {
        const Json json = Json::parse(text);
        for (const Json& one : json.at("criteria")) {
            const Json& value = one.at("value");
            verdict.criteria.push_back(
                {one.at("name"),
                 value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(),
                 one.at("tolerance"), one.at("holds")});
        }
    } catch (const Json::exception& reason) {
        throw InputError(
            fmt::format("verdict '{}' is not a verdict of a run ({}); "
                        "run the scene again to get one",
                        text.substr(0, 60), reason.what()));
    }
    return verdict;
}

std::string to_text(const Verdict& verdict) {
    std::string out;
    for (const Criterion& one : verdict.criteria) {
        const std::string value =
            std::isnan(one.value) ? "unknown" : fmt::format("{:.3e}", one.value);
        out += fmt::format("  {:<24}{:>11}  (<= {:.3g})  {}\n", one.name, value, one.tolerance,
                           one.holds ? "holds" : "does not hold");
    }
    return out;
}

}  // namespace jam
