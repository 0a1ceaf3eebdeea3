// SPDX-License-Identifier: BSD-3-Clause
// The statistics of a packing as JSON and as a table.
#pragma once

#include "analysis/elasticity.h"
#include "analysis/packing_statistics.h"

#include <nlohmann/json.hpp>

#include <string>

namespace jam::apps {

/// Keys are part of the program's interface (docs/analysis.md lists them); numbers with every
/// digit; null where a quantity is undefined.
nlohmann::ordered_json statistics_json(const PackingStatistics& statistics);

/// For people: a dozen lines, numbers rounded.
std::string statistics_table(const PackingStatistics& statistics, const std::string& name);

/// What --elastic adds to each of them.
nlohmann::ordered_json elasticity_json(const Elasticity& elasticity);
std::string elasticity_table(const Elasticity& elasticity);

}  // namespace jam::apps
