// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_history.h"

#include "core/check.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>

namespace jam {

namespace {

using Json = nlohmann::json;
using Row = std::array<double, 7>;

double number(const Json& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

double third_of_trace(const Json& matrix) {
    return (number(matrix.at(0).at(0)) + number(matrix.at(1).at(1)) + number(matrix.at(2).at(2))) /
           3.0;
}

Row row_from(const std::string& line, const std::filesystem::path& path, Count line_number) {
    try {
        const Json record = Json::parse(line);
        return {number(record.at("step")),
                number(record.at("time")),
                number(record.at("volume_fraction")),
                number(record.at("coordination")),
                number(record.at("coordination_nr")),
                number(record.at("cundall")),
                third_of_trace(record.at("pressure"))};
    } catch (const Json::exception& reason) {
        throw InputError(fmt::format("{}:{}: not a record of a run ({}); remove the line",
                                     path.string(), line_number, reason.what()));
    }
}

/// Every so many, and the last.
std::vector<Row> thinned(const std::vector<Row>& rows, Count most) {
    const auto count = static_cast<Count>(rows.size());
    if (count <= most) return rows;
    std::vector<Row> kept;
    for (Count k = 0; k < most; ++k) kept.push_back(rows[(count - 1) * k / (most - 1)]);
    return kept;
}

}  // namespace

Table read_run_history(const std::filesystem::path& path, Count rows) {
    std::ifstream file(path);
    if (!file)
        throw FileError(
            fmt::format("{}: cannot be read ({})", path.string(), std::strerror(errno)));
    std::vector<Row> records;
    Count line_number = 0;
    for (std::string line; std::getline(file, line);) {
        ++line_number;
        if (!line.empty()) records.push_back(row_from(line, path, line_number));
    }
    Table table;
    for (const char* name : {"step", "time", "volume_fraction", "coordination", "coordination_nr",
                             "cundall", "pressure"})
        table.columns.push_back({name, {}});
    for (const Row& row : thinned(records, rows))
        for (std::size_t c = 0; c < row.size(); ++c) table.columns[c].values.push_back(row[c]);
    return table;
}

}  // namespace jam
