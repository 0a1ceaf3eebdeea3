// SPDX-License-Identifier: BSD-3-Clause
// Numbers by column: what every distribution gives, ready for a CSV file or a plot.
#pragma once

#include <string>
#include <vector>

namespace jam {

struct Column {
    std::string name;  ///< as in docs/analysis.md; without commas
    std::vector<double> values;
};

/// All columns have one length.
struct Table {
    std::vector<Column> columns;
};

/// A line of names, then a line for each row; every digit, "nan" where there is no number.
std::string csv_text(const Table& table);

}  // namespace jam
