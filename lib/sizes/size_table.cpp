// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/size_table.h"

#include "core/check.h"
#include "sizes/power_segment.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace jam {

namespace {

// Says where the number with this index stands, for messages.
using Place = std::function<std::string(std::size_t)>;

void check_diameters(const std::vector<double>& diameters, const Place& place) {
    for (std::size_t i = 0; i < diameters.size(); ++i)
        require(std::isfinite(diameters[i]) && diameters[i] > 0.0,
                "{}: diameter {}; must be a finite number above zero; correct or remove it",
                place(i), diameters[i]);
}

void check_span(double smallest, double largest, const Place& place) {
    require(
        largest <= max_size_ratio * smallest,
        "{}: the largest diameter, {}, is more than {} times the smallest, {}; narrow the table",
        place(0), largest, max_size_ratio, smallest);
}

DiameterList build_list(std::vector<double> diameters, const Place& place) {
    require(!diameters.empty(), "{}: no diameters; give at least one", place(0));
    check_diameters(diameters, place);
    std::ranges::sort(diameters);
    check_span(diameters.front(), diameters.back(), place);

    std::vector<double> volume(diameters.size());
    std::transform_inclusive_scan(diameters.begin(), diameters.end(), volume.begin(), std::plus{},
                                  [](double diameter) { return diameter * diameter * diameter; });
    const double all = volume.back();
    for (double& fraction : volume) fraction /= all;
    return {std::move(diameters), std::move(volume)};
}

void check_fractions(const std::vector<double>& fractions, const Place& place) {
    const std::size_t last = fractions.size() - 1;
    require(fractions[0] == 0.0 && fractions[1] > 0.0,
            "{}: the first fractions are {} and {}; the curve must begin with the smallest "
            "diameter, where it is 0 and from where it rises; add or remove rows there",
            place(0), fractions[0], fractions[1]);
    for (std::size_t i = 1; i <= last; ++i)
        require(fractions[i] >= fractions[i - 1],
                "{}: cumulative fraction {} after {}; it must never fall; give the fraction of all "
                "that is smaller, not that of the interval",
                place(i), fractions[i], fractions[i - 1]);
    require(fractions[last] == 1.0 && fractions[last - 1] < 1.0,
            "{}: the last fractions are {} and {}; the curve must reach 1, once, at the largest "
            "diameter; divide percents by 100, remove rows after the first 1",
            place(last), fractions[last - 1], fractions[last]);
}

void check_curve(const std::vector<double>& diameters, const std::vector<double>& fractions,
                 const Place& place) {
    require(diameters.size() == fractions.size() && diameters.size() >= 2,
            "{}: {} diameters and {} fractions; a cumulative curve has as many of one as of the "
            "other, and at least 2; add what is missing",
            place(0), diameters.size(), fractions.size());
    check_diameters(diameters, place);
    for (std::size_t i = 1; i < diameters.size(); ++i)
        require(diameters[i] > diameters[i - 1],
                "{}: diameter {} after {}; must be larger than the one before; sort the rows, "
                "and give a jump some width",
                place(i), diameters[i], diameters[i - 1]);
    check_span(diameters.front(), diameters.back(), place);
    check_fractions(fractions, place);
}

// The same curve counted by number where it was given by volume, and the other way round. Between
// two points the given density is constant, n(D) ~ D^-3 or n(D) ~ 1.
std::vector<double> converted(const std::vector<double>& diameters,
                              const std::vector<double>& fractions, Weight given) {
    const double exponent = given == Weight::volume ? -2.0 : 4.0;
    std::vector<double> other(fractions.size(), 0.0);
    for (std::size_t i = 1; i < other.size(); ++i) {
        const double from = diameters[i - 1];
        const double to = diameters[i];
        other[i] = other[i - 1] + (fractions[i] - fractions[i - 1]) *
                                      power_integral(exponent, from, to) / (to - from);
    }
    const double all = other.back();
    for (double& fraction : other) fraction /= all;
    return other;
}

CumulativeCurve build_curve(std::vector<double> diameters, std::vector<double> fractions,
                            Weight given, const Place& place) {
    check_curve(diameters, fractions, place);
    std::vector<double> other = converted(diameters, fractions, given);
    if (given == Weight::number) std::swap(fractions, other);
    return {given, std::move(diameters), std::move(other), std::move(fractions)};
}

// ---- files

// The columns of a file, and the line of each row.
struct Columns {
    std::vector<std::vector<double>> numbers;
    std::vector<Count> lines;
};

// The numbers of one line, or nothing if a word in it is not a number.
std::optional<std::vector<double>> parse_numbers(std::string_view line) {
    constexpr std::string_view separators = ",; \t\r";
    std::vector<double> numbers;
    std::size_t begin = line.find_first_not_of(separators);
    while (begin < line.size()) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        double number = 0.0;
        const auto [rest, error] = std::from_chars(line.data() + begin, line.data() + end, number);
        if (error != std::errc{} || rest != line.data() + end) return std::nullopt;
        numbers.push_back(number);
        begin = line.find_first_not_of(separators, end);
    }
    return numbers;
}

bool is_heading(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\"");
    return first != line.npos && std::isalpha(static_cast<unsigned char>(line[first])) != 0;
}

void add_row(Columns& columns, const std::vector<double>& row, Count line,
             const std::string& where) {
    if (columns.numbers.empty()) columns.numbers.resize(row.size());
    require(row.size() <= 2 && row.size() == columns.numbers.size(),
            "{}: {} columns; every row must have one (diameter) or every row two (diameter, "
            "cumulative fraction); remove the others, and write decimals with a point",
            where, row.size());
    for (std::size_t c = 0; c < row.size(); ++c) columns.numbers[c].push_back(row[c]);
    columns.lines.push_back(line);
}

Columns read_columns(std::istream& file, const Place& at_line) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // spreadsheets write it
    Columns columns;
    std::string text;
    bool heading_may_come = true;
    for (Count number = 1; std::getline(file, text); ++number) {
        std::string_view line = text;
        if (number == 1 && line.starts_with(byte_order_mark))
            line.remove_prefix(byte_order_mark.size());
        line = line.substr(0, line.find('#'));
        const auto row = parse_numbers(line);
        const bool heading = !row && std::exchange(heading_may_come, false) && is_heading(line);
        if (heading || (row && row->empty())) continue;
        const std::string where = at_line(static_cast<std::size_t>(number));
        require(row.has_value(), "{}: '{}' is not a row of numbers; correct or remove it", where,
                line);
        add_row(columns, *row, number, where);
        heading_may_come = false;
    }
    return columns;
}

}  // namespace

DiameterList diameter_list(std::vector<double> diameters) {
    return build_list(std::move(diameters),
                      [](std::size_t i) { return fmt::format("diameter {}", i + 1); });
}

CumulativeCurve cumulative_curve(std::vector<double> diameters, std::vector<double> fractions,
                                 Weight given) {
    return build_curve(std::move(diameters), std::move(fractions), given,
                       [](std::size_t i) { return fmt::format("point {}", i + 1); });
}

SizeDistribution read_size_table(const std::filesystem::path& path, Weight given) {
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path))
        throw FileError(fmt::format(
            "sizes.file = {}: cannot be read; give the path of a CSV file with one or two columns",
            path.string()));
    const Place at_line = [&](std::size_t line) {
        return fmt::format("sizes.file = {}, line {}", path.string(), line);
    };
    Columns columns = read_columns(file, at_line);
    require(!columns.lines.empty(), "sizes.file = {}: holds no numbers; give at least one diameter",
            path.string());

    const Place at_row = [&](std::size_t row) {
        return at_line(static_cast<std::size_t>(columns.lines[row]));
    };
    if (columns.numbers.size() == 1) return build_list(std::move(columns.numbers[0]), at_row);
    return build_curve(std::move(columns.numbers[0]), std::move(columns.numbers[1]), given, at_row);
}

}  // namespace jam
