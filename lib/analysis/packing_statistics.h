// SPDX-License-Identifier: BSD-3-Clause
// The numbers that one packing is known by.
#pragma once

#include "analysis/force_network.h"

namespace jam {

/// Suffix _nr: of the backbone. What is undefined (Cundall without contacts) is not a number.
struct PackingStatistics {
    Count particle_count = 0;
    double size_ratio = 0.0;  ///< largest over smallest diameter
    double volume_fraction = 0.0;
    double volume_fraction_nr = 0.0;  ///< of the backbone's particles alone
    double coordination = 0.0;
    double coordination_nr = 0.0;
    int rattler_threshold = default_rattler_threshold;
    Count rattler_count = 0;
    double rattler_fraction = 0.0;
    Count unheld_count = 0;  ///< rattlers by the stricter test (unheld.h)
    Count contact_count = 0;
    Count contact_count_nr = 0;
    Count isostatic_contact_count = 0;  ///< for the backbone in a cell free in all six components
    double cundall = 0.0;
    double cundall_nr = 0.0;
    Mat3 pressure = Mat3::Zero();  ///< static, from the elastic forces
    Mat3 cell = Mat3::Zero();      ///< rows are the edges a, b, c
    double largest_overlap = 0.0;  ///< over the smaller diameter of the two
    double mean_overlap = 0.0;     ///< over the smaller diameter of the two
    double kinetic_energy_per_particle = 0.0;

    Count excess_contact_count() const { return contact_count_nr - isostatic_contact_count; }
};

/// Throws InputError if the packing has no particles.
PackingStatistics packing_statistics(const Packing& packing, const ForceNetwork& network);

}  // namespace jam
