// SPDX-License-Identifier: BSD-3-Clause
// A packing as it is saved and analysed: one moment of a run, or what another program made.
#pragma once

#include "cell/periodic_cell.h"
#include "core/types.h"
#include "particles/material.h"

#include <cstdint>
#include <string>
#include <vector>

namespace jam {

/// Where a packing comes from; every text may be empty.
struct Provenance {
    std::string creator;  ///< program and version
    std::string command_line;
    std::string scene;    ///< the whole scene file, as run
    std::string verdict;  ///< JSON: which criteria hold, with values
    std::uint64_t seed = 0;
};

/// N spheres in a periodic cell. All vectors have length N, except that velocities may be empty.
struct Packing {
    PeriodicCell cell;
    std::vector<Vec3> positions;  ///< Cartesian; inside the cell or any image of it
    std::vector<double> diameters;
    std::vector<Vec3> velocities;   ///< relative to the cell's flow; empty: at rest
    std::vector<std::int64_t> ids;  ///< distinct; any order
    Material material;
    Count step = 0;
    double time = 0.0;
    Mat3 applied_pressure = Mat3::Zero();
    Provenance provenance;

    Count size() const { return static_cast<Count>(positions.size()); }
};

/// Throws InputError unless the packing has at least one sphere, vectors of one length, finite
/// numbers, diameters above zero and distinct ids. Whatever is saved or read passes through here.
void check_packing(const Packing& packing);

}  // namespace jam
