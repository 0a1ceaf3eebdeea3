// SPDX-License-Identifier: BSD-3-Clause
// Packings in whatever format the end of a file's name says: .h5 (our own, packing_file.h), .dump
// and .data (LAMMPS), .xyz (extended XYZ), .csv.
#pragma once

#include "packing/packing.h"

#include <filesystem>
#include <string>

namespace jam {

/// Reads a packing. Where the name does not say the format, our own files and LAMMPS dumps are
/// known by their first bytes. Throws InputError and FileError.
Packing read_packing(const std::filesystem::path& path);

/// Writes a packing, whole or not at all. Throws InputError, also for a name that says no format,
/// and FileError.
void write_packing(const Packing& packing, const std::filesystem::path& path);

/// What of this packing would be lost by writing it to a file of this name, as a sentence; "" if
/// nothing. Throws InputError for a name that says no format.
std::string what_is_lost(const Packing& packing, const std::filesystem::path& path);

}  // namespace jam
