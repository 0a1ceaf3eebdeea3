// SPDX-License-Identifier: BSD-3-Clause
// The outcome of a run as a packing's file.
#pragma once

#include "jamming/jam_packing.h"

#include <filesystem>

namespace jam {

/// Writes the packing of `result` with its contacts and, as observables, what was measured of it:
/// volume_fraction, coordination, coordination_nr, rattler_fraction, cundall,
/// kinetic_energy_per_particle and pressure (static). Throws as save_packing.
void save_jammed(const JamResult& result, const std::filesystem::path& path);

}  // namespace jam
