// SPDX-License-Identifier: BSD-3-Clause
// A packing in one HDF5 file that is H5MD 1.1 and VTKHDF 1.0 at once, with no array in it twice:
// h5py, MDAnalysis, VTK and ParaView open it as it is. docs/file-format.md draws the layout.
#pragma once

#include "packing/packing.h"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace jam {

/// What else goes into a packing's file, for other programs to read.
struct PackingExtras {
    std::vector<std::pair<std::string, double>> numbers;  ///< /observables, by name: phi, Z, ...
    std::vector<std::pair<std::string, Mat3>> tensors;    ///< likewise: pressure, ...
    std::span<const std::array<Index, 2>> contacts;       ///< pairs of places in the arrays
};

/// Writes `packing` to `path`, whole or not at all (core/whole_file.h). The same packing gives the
/// same bytes. Throws InputError if the packing is not fit to be read back (check_packing) and
/// FileError if the disk fails; an earlier file then stays as it was.
void save_packing(const Packing& packing, const std::filesystem::path& path,
                  const PackingExtras& extras = {});

/// Reads back the same bits. Throws FileError for a file that is missing, foreign or damaged.
/// Files that other programs wrote in this layout may lack /parameters (defaults are taken then)
/// and velocities.
Packing load_packing(const std::filesystem::path& path);

}  // namespace jam
