// SPDX-License-Identifier: BSD-3-Clause
// How many contacts a particle has on average, and how many it needs.
#pragma once

#include "analysis/force_network.h"

namespace jam {

/// Z = 2 N_c / N over all particles; 0 without particles.
double coordination(const ForceNetwork& network);

/// Z_nr = 2 N_c,nr / N_nr over the backbone and the contacts within it; 0 without a backbone.
double coordination_nr(const ForceNetwork& network);

/// Fewest contacts that can hold a frictionless backbone of N_nr spheres in a periodic cell of
/// which `free_cell_components` (0..6) follow the stress: N_iso = 3 N_nr - 3 + max(1, free
/// components), 3 N_nr + 3 for a cell that is free in all six (Dagois-Bohy et al., Phys. Rev. Lett.
/// 109, 095703, 2012). 0 without a backbone. docs/analysis.md derives it.
Count isostatic_contact_count(Count backbone_count, int free_cell_components = 6);

}  // namespace jam
