// SPDX-License-Identifier: BSD-3-Clause
// The outcome of a run as a packing's file.
#pragma once

#include "jamming/jam_packing.h"

#include <filesystem>

namespace jam {

/// Writes the packing of `result` with what was measured of it (analysis/measured_file.h).
void save_jammed(const JamResult& result, const std::filesystem::path& path);

}  // namespace jam
