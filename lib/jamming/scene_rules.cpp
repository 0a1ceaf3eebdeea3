// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene_rules.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>

namespace jam {

/// Digits d with the decimal point behind the first: d x 10^exponent.
static std::string scientific(const std::string& digits, long exponent) {
    const std::string fraction = digits.substr(1);
    return fmt::format("{}{}{}e{}", digits[0], fraction.empty() ? "" : ".", fraction, exponent);
}

/// 1000000 as 1e6 and 0.0001 as 1e-4, so that nobody need count the zeros.
static std::string without_zeros(const std::string& text) {
    constexpr std::size_t most_digits = 4;
    const std::size_t first = text.find_first_not_of("0.");
    const std::size_t last = text.find_last_not_of("0.");
    if (first == std::string::npos || last - first >= most_digits) return text;
    const std::string digits = text.substr(first, last - first + 1);
    if (text.find('.') == std::string::npos && text.size() >= 7)
        return scientific(digits, static_cast<long>(text.size()) - 1);
    if (text.starts_with("0.00")) return scientific(digits, 1 - static_cast<long>(first));
    return text;
}

std::string number_text(double number) {
    const std::string text = fmt::format("{}", number);
    const std::size_t exponent = text.find('e');
    if (exponent == std::string::npos) return without_zeros(text);
    const std::size_t digits = text.find_first_not_of("+-0", exponent + 1);
    return fmt::format("{}{}{}", text.substr(0, exponent + 1), text[exponent + 1] == '-' ? "-" : "",
                       text.substr(digits));
}

/// Whole numbers are numbers, too.
static std::optional<double> as_number(const SceneValue& value) {
    if (const auto* whole = std::get_if<Count>(&value)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    return std::nullopt;
}

std::string Real::text() const {
    if (least_included && most_included)
        return fmt::format("a number from {} to {}", number_text(least), number_text(most));
    return fmt::format("a number {} {} and {} {}", least_included ? "at least" : "above",
                       number_text(least), most_included ? "at most" : "below", number_text(most));
}

std::optional<double> Real::read(const SceneValue& value) const {
    const std::optional<double> number = as_number(value);
    if (!number) return std::nullopt;
    const bool inside = (least_included ? *number >= least : *number > least) &&
                        (most_included ? *number <= most : *number < most);
    return inside ? number : std::nullopt;  // NaN is not inside
}

std::optional<bool> YesNo::read(const SceneValue& value) const {
    const auto* given = std::get_if<bool>(&value);
    return given ? std::optional(*given) : std::nullopt;
}

std::string Whole::text() const {
    if (most == std::numeric_limits<Count>::max())
        return fmt::format("a whole number, at least {}", least);
    return fmt::format("a whole number from {} to {}", least, most);
}

std::optional<Count> Whole::read(const SceneValue& value) const {
    constexpr double exact = 9007199254740992.0;  // 2^53: up to here a double is a whole number
    Count number = 0;
    if (const auto* whole = std::get_if<Count>(&value)) {
        number = *whole;
    } else if (const auto* real = std::get_if<double>(&value)) {
        if (!(std::abs(*real) <= exact) || *real != std::floor(*real)) return std::nullopt;
        number = static_cast<Count>(*real);
    } else {
        return std::nullopt;
    }
    return number >= least && number <= most ? std::optional(number) : std::nullopt;
}

std::optional<std::filesystem::path> PathText::read(const SceneValue& value) const {
    const auto* text = std::get_if<std::string>(&value);
    if (!text || text->empty() || text->find('\0') != std::string::npos) return std::nullopt;
    return std::filesystem::path(*text);
}

std::optional<SceneValue> PathText::write(const std::filesystem::path& path) const {
    return path.empty() ? std::nullopt : std::optional<SceneValue>(path.string());
}

std::optional<std::optional<double>> RealOrAutomatic::read(const SceneValue& value) const {
    const auto* word = std::get_if<std::string>(&value);
    if (word && *word == "automatic") return std::optional<double>();  // read: no number
    const std::optional<double> chosen = number.read(value);
    if (!chosen) return std::nullopt;
    return std::optional<std::optional<double>>(chosen);
}

std::optional<SceneValue> RealOrAutomatic::write(const std::optional<double>& chosen) const {
    return chosen ? SceneValue(*chosen) : SceneValue("automatic");
}

std::string PressureTensor::text() const {
    return fmt::format(
        "a number above 0 and at most {}, or six [xx, yy, zz, yz, xz, xy] of a "
        "tensor with positive principal values",
        number_text(most));
}

static Mat3 symmetric(const std::vector<double>& six) {
    Mat3 out;
    out << six[0], six[5], six[4],  //
        six[5], six[1], six[3],     //
        six[4], six[3], six[2];
    return out;
}

std::optional<Mat3> PressureTensor::read(const SceneValue& value) const {
    if (const auto* six = std::get_if<std::vector<double>>(&value)) {
        const auto fits = [this](double x) { return std::abs(x) <= most; };  // NaN does not
        if (six->size() != 6 || !std::ranges::all_of(*six, fits)) return std::nullopt;
        const Mat3 pressure = symmetric(*six);
        const Eigen::SelfAdjointEigenSolver<Mat3> principal(pressure, Eigen::EigenvaluesOnly);
        return principal.eigenvalues()[0] > 0.0 ? std::optional(pressure) : std::nullopt;
    }
    const std::optional<double> number = above(0.0, most).read(value);
    return number ? std::optional<Mat3>(Mat3::Identity() * *number) : std::nullopt;
}

std::optional<SceneValue> PressureTensor::write(const Mat3& p) const {
    if (p == Mat3(Mat3::Identity() * p(0, 0))) return p(0, 0);
    return std::vector<double>{p(0, 0), p(1, 1), p(2, 2), p(1, 2), p(0, 2), p(0, 1)};
}

}  // namespace jam
