// SPDX-License-Identifier: BSD-3-Clause
// How many contacts the particles of the backbone have.
#pragma once

#include "analysis/rattlers.h"
#include "analysis/table.h"

namespace jam {

/// f_c: the fraction of the backbone's particles that have exactly c contacts within it; sum_c f_c
/// = 1 and sum_c c f_c = Z_nr (Monti et al., Fig. 6, inset). All zero without a backbone.
struct ContactNumbers {
    std::vector<Count> particle_counts;  ///< by c, from 0 to the largest

    /// Particles with low <= c <= high, over all of the backbone.
    double share_of_particles(int low, int high) const;
    /// Their part of Z_nr: sum of c f_c over the same c, over Z_nr.
    double share_of_contacts(int low, int high) const;
};

ContactNumbers contact_numbers(const Rattlers& rattlers);

/// Columns contacts, particles, fraction.
Table table(const ContactNumbers& numbers);

}  // namespace jam
