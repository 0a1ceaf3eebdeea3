// SPDX-License-Identifier: BSD-3-Clause
// The elastic answer of a packing as it is: whether it stands, and how stiff it is.
#pragma once

#include "analysis/elastic_moduli.h"
#include "analysis/stability.h"

namespace jam {

struct Elasticity {
    Count particle_count = 0;  ///< particles that four contacts or more hold: those that answer
    double pressure = 0.0;     ///< mean of the contacts among them: what the Hessian is taken at
    Stability stability;       ///< in a cell that is free in all six components
    ElasticModuli moduli;
};

/// Of the particles that four contacts or more hold (rattlers.h), as of those that the criterion of
/// stability looks at. Throws InputError if there are more than `most_particles` of them, since
/// time grows with the square of their number, about half a minute at 10,000.
Elasticity find_elasticity(const Packing& packing, const ForceNetwork& network,
                           Count most_particles = 20000);

}  // namespace jam
