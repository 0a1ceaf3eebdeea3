// SPDX-License-Identifier: BSD-3-Clause
// What a run tells of itself as it goes: one record every so many steps.
#pragma once

#include "core/types.h"

#include <limits>
#include <string>

namespace jam {

/// One line of record.jsonl. Every quantity belongs to the same step; NaN where it is not known.
///
/// Pressure and Cundall parameter come twice: the static ones from the elastic contact forces
/// alone, which is what a saved packing can be checked against, and the dynamic ones with the
/// damping forces (and for the pressure the kinetic part) in them.
struct Record {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    Count step = 0;
    double time = 0.0;  ///< simulated, in units of sqrt(mass/stiffness)
    double volume_fraction = unknown;
    double coordination = unknown;            ///< contacts a particle, all particles
    double coordination_nr = unknown;         ///< the same, rattlers and their contacts left out
    double rattler_fraction = unknown;        ///< of all particles, by number
    Mat3 pressure = Mat3::Constant(unknown);  ///< static
    Mat3 pressure_dynamic = Mat3::Constant(unknown);
    double cundall = unknown;  ///< static (Monti et al., Methods)
    double cundall_dynamic = unknown;
    double kinetic_energy_per_particle = unknown;
    Mat3 cell = Mat3::Constant(unknown);  ///< columns are the edges a, b, c
    double wall_seconds = 0.0;            ///< since the run began, earlier sittings included
    double steps_per_second = unknown;    ///< since the record before
};

/// One line of JSON without its line end. Keys are the fields' names; unknown values are null;
/// `cell` is written with the edges as rows, as everywhere in files. Numbers read back to the same
/// bits.
std::string json_line(const Record& record);

/// The reverse of json_line. Throws InputError if the line is not such a record.
Record record_from_json(const std::string& line);

}  // namespace jam
