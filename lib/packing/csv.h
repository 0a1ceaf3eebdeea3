// SPDX-License-Identifier: BSD-3-Clause
// A table of spheres as comma-separated values, for spreadsheets and one-off scripts.
#pragma once

#include "packing/packing.h"

#include <filesystem>

namespace jam {

/// Reads comment lines, one of which is "# cell: ax ay az bx by bz cx cy cz" (a along x, b in the
/// plane of x and y), a line of column names (id, diameter or radius, x, y, z, and vx, vy, vz if
/// there; others are skipped) and one line a sphere. Throws InputError (file, line, what was
/// expected, remedy) and FileError.
Packing read_csv(const std::filesystem::path& path);

/// Writes id,diameter,x,y,z[,vx,vy,vz], each number with the digits that give the same number back,
/// whole or not at all. Throws InputError (check_packing) and FileError.
void write_csv(const Packing& packing, const std::filesystem::path& path);

}  // namespace jam
