// SPDX-License-Identifier: BSD-3-Clause
// A packing's file with what was measured of it, for other programs to read.
#pragma once

#include "analysis/packing_statistics.h"

#include <filesystem>

namespace jam {

/// Writes the packing (packing_file.h) with its contacts and, as observables: volume_fraction,
/// coordination, coordination_nr, rattler_fraction, cundall, kinetic_energy_per_particle and
/// pressure (static). Throws as save_packing.
void save_measured(const Packing& packing, const ForceNetwork& network,
                   const PackingStatistics& statistics, const std::filesystem::path& path);

}  // namespace jam
