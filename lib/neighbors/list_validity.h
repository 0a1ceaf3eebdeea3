// SPDX-License-Identifier: BSD-3-Clause
// Whether a list still holds every pair that could touch.
#pragma once

#include "cell/periodic_cell.h"
#include "grids/interaction_reach.h"
#include "particles/particles.h"

#include <vector>

namespace jam {

/// What a list was made for: where particles stood, in which cell, and how far it reached.
struct ListReference {
    PeriodicCell cell;
    std::vector<Vec3> centers;  ///< fractional, length N
    InteractionReach reach;
};

/// How far particles have moved within the cell: the largest |h (s - s_0)|, h the cell now.
double largest_displacement(const ListReference& reference, const PeriodicCell& now,
                            const Particles& particles);

/// True as long as no unlisted pair can touch. With F the deformation of the cell since the
/// reference and sigma its smallest singular value, an unlisted pair is apart by at least sigma
/// ((D_i + D_j)/2 (1 + strain_margin) + 2 skin) - 2 displacement, which is no contact while sigma
/// (1 + strain_margin) >= 1 and displacement <= sigma skin: the cell's strain and the motion within
/// it are tested apart, and nothing depends on where in the cell a pair lies.
bool list_is_valid(const ListReference& reference, const PeriodicCell& now, double displacement);

}  // namespace jam
