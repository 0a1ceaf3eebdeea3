// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/table.h"

#include <fmt/format.h>

#include <iterator>

namespace jam {

std::string csv_text(const Table& table) {
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        fmt::format_to(out, "{}{}", c == 0 ? "" : ",", table.columns[c].name);
    fmt::format_to(out, "\n");
    const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().values.size();
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            fmt::format_to(out, "{}{}", c == 0 ? "" : ",", table.columns[c].values[row]);
        fmt::format_to(out, "\n");
    }
    return fmt::to_string(text);
}

}  // namespace jam
