// SPDX-License-Identifier: BSD-3-Clause
// A comparison as JSON and as a table.
#pragma once

#include "analysis/compare_packings.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace jam::apps {

/// `paths_a` and `paths_b` are the packings of the two groups. null where no scatter is known.
nlohmann::ordered_json comparison_json(const PackingComparison& comparison,
                                       const std::vector<std::string>& paths_a,
                                       const std::vector<std::string>& paths_b);

std::string comparison_table(const PackingComparison& comparison, const std::string& name_a,
                             const std::string& name_b);

}  // namespace jam::apps
