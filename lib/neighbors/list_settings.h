// SPDX-License-Identifier: BSD-3-Clause
// How the lists of a run are made. Nothing but the time of a run depends on it, and the last bits.
#pragma once

#include "neighbors/neighbor_method.h"

#include <optional>

namespace jam {

struct ListSettings {
    NeighborMethod method = NeighborMethod::multi;
    std::optional<double> collection_ratio;  ///< nothing: chosen by the cost of a search
    double outer_skin = 0.1;                 ///< of the candidates at least, in smallest diameters
    double widest_outer_skin = 0.8;
    double outer_steps = 50.0;          ///< of the last step's motion that it should outlast
    double outer_strain_margin = 0.02;  ///< of the candidates
    double inner_steps = 50.0;          ///< steps of present motion that the tiles should outlast
};

}  // namespace jam
