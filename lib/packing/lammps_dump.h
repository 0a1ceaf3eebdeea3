// SPDX-License-Identifier: BSD-3-Clause
// LAMMPS dump files (dump custom): what LAMMPS, OVITO and many scripts of the field read and write.
#pragma once

#include "packing/packing.h"

#include <filesystem>

namespace jam {

inline constexpr Count last_frame = -1;

/// Reads one frame, counted from 0; the last one unless told otherwise. Columns in any order: id,
/// diameter or radius, positions as x y z, xu yu zu, xs ys zs or xsu ysu zsu, and velocities vx vy
/// vz if there; others are skipped. The cell may be orthogonal or restricted triclinic, whose
/// bounds stand in the file as those of the box around it; its origin is taken off the positions.
/// Material and pressure are not in such a file and stay at their defaults. Throws InputError
/// (file, line, what was expected, remedy) and FileError.
Packing read_lammps_dump(const std::filesystem::path& path, Count frame = last_frame);

/// Writes one frame: id type diameter x y z [vx vy vz], each number with the digits that give the
/// same number back, whole or not at all. Ids are shifted to start at 1 if any is below. Throws
/// InputError (check_packing) and FileError.
void write_lammps_dump(const Packing& packing, const std::filesystem::path& path);

}  // namespace jam
