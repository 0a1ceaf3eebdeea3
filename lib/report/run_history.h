// SPDX-License-Identifier: BSD-3-Clause
// What a run recorded of itself (record.jsonl), for its figure.
#pragma once

#include "analysis/table.h"
#include "core/types.h"

#include <filesystem>

namespace jam {

/// Columns step, time, volume_fraction, coordination, coordination_nr, cundall, pressure (a third
/// of the trace of the static tensor); one row a record, thinned evenly to at most `rows` of them,
/// the last one kept. Not a number where a record does not know. Throws InputError for a line that
/// is no record, FileError for a file that cannot be read.
Table read_run_history(const std::filesystem::path& path, Count rows = 2000);

}  // namespace jam
