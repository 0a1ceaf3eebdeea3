// SPDX-License-Identifier: BSD-3-Clause
// LAMMPS data files of atom_style sphere: what its read_data takes and its write_data gives.
#pragma once

#include "packing/packing.h"

#include <filesystem>
#include <span>

namespace jam {

/// Reads the box, the section Atoms (id type diameter density x y z, image flags allowed and not
/// used) and, if there, Velocities. All spheres must have one density, which becomes the
/// material's; the box' origin is taken off the positions. Throws InputError (file, line, what was
/// expected, remedy) and FileError.
Packing read_lammps_data(const std::filesystem::path& path);

/// Writes such a file, each number with the digits that give the same number back, whole or not at
/// all. LAMMPS refuses tilts beyond half an edge, so the cell is written reduced: the same lattice.
/// Ids are shifted to start at 1 if any is below. `densities`: one a sphere in place of the
/// material's, from which LAMMPS has the masses. Throws InputError (check_packing) and FileError.
void write_lammps_data(const Packing& packing, const std::filesystem::path& path,
                       std::span<const double> densities = {});

}  // namespace jam
