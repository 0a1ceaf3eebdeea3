// SPDX-License-Identifier: BSD-3-Clause
// Extended XYZ files, as OVITO and ASE read and write them.
#pragma once

#include "packing/packing.h"

#include <filesystem>

namespace jam {

/// Reads the last frame. The comment line must have Lattice="ax ay az bx by bz cx cy cz" (a along
/// x, b in the plane of x and y) and Properties with pos:R:3 and radius:R:1 or diameter:R:1; pbc,
/// if there, must be T T T. id:I:1, velo:R:3 and the keys Time, Step and Origin are taken if there,
/// all else is skipped.
/// Throws InputError (file, line, what was expected, remedy) and FileError.
Packing read_extended_xyz(const std::filesystem::path& path);

/// Writes one frame with the columns species (X), pos, radius, id and, if there, velo, in this
/// order; each number with the digits that give the same number back, whole or not at all. Throws
/// InputError (check_packing) and FileError.
void write_extended_xyz(const Packing& packing, const std::filesystem::path& path);

}  // namespace jam
