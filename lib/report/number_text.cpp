// SPDX-License-Identifier: BSD-3-Clause
#include "report/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace jam {

namespace {

std::string superscript(int power) {
    constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = power < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(power)))
        text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

}  // namespace

std::string grouped(Count number) {
    if (number < 0) return "−" + grouped(-number);
    if (number < 1000) return fmt::format("{}", number);
    return fmt::format("{}\u202f{:03}", grouped(number / 1000), number % 1000);
}

std::string short_number(double number) {
    if (!std::isfinite(number)) return "–";
    if (number < 0.0) return "−" + short_number(-number);
    if (number == 0.0) return "0";
    if (number >= 999.5 && number < 1e5) return fmt::format("{:.0f}", number);
    if (number >= 1e-3 && number < 999.5) return fmt::format("{:.3g}", number);
    const std::string text = fmt::format("{:.2e}", number);  // d.dde-pp
    const std::size_t e = text.find('e');
    std::string factor = text.substr(0, e);
    while (factor.back() == '0') factor.pop_back();
    if (factor.back() == '.') factor.pop_back();
    const std::string power = "10" + superscript(std::stoi(text.substr(e + 1)));
    return factor == "1" ? power : factor + "\u00a0×\u00a0" + power;
}

std::string with_error(double value, double error) {
    if (std::isnan(value)) return "–";
    if (!(error > 0.0)) return fmt::format("{:.4f}", value);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(error))), 0, 6);
    const long last_digits = std::lround(error * std::pow(10.0, decimals));
    return fmt::format("{:.{}f}({})", value, decimals, last_digits);
}

}  // namespace jam
