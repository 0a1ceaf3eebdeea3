// SPDX-License-Identifier: BSD-3-Clause
// The metric in which a relaxation moves: one 3x3 block a particle and one number for each
// component of the cell, so that no direction is much softer than another.
//
// Near jamming some particles are held by two, three or four contacts and about to buckle aside.
// With one mass for a particle that motion takes 1/sqrt(p) steps; with a block made of the
// directions of its contacts it takes as few as any other.
#pragma once

#include "cell/periodic_cell.h"
#include "jamming/active_particles.h"
#include "neighbors/neighbor_list.h"
#include "particles/material.h"
#include "particles/particles.h"

#include <vector>

namespace jam {

/// A symmetric 3x3 matrix.
struct SymmetricBlock {
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

/// What the contacts around each particle resist: running means, which belong to a run's state.
struct ContactStiffness {
    std::vector<SymmetricBlock> blocks;  ///< by id: sum over contacts of k n n^T
    std::vector<double> contacts;        ///< by id: how many there were at the last renewal
    double typical = 0.0;                ///< k of a contact in the mean
    Mat3 cell = Mat3::Zero();            ///< component (a, b): sum over contacts of k n_a^2 r_b^2

    bool empty() const { return blocks.empty(); }
};

/// The inverse of a particle's block M.
struct alignas(64) BlockResponse {
    SymmetricBlock inverse;
    double mass = 1.0;  ///< a third of the trace of M
};

struct RelaxationMetric {
    std::vector<BlockResponse> particles;  ///< by place in the arrays
    Mat3 cell_inertia = Mat3::Ones();      ///< upper triangle
};

/// Both directions of every listed pair, so that each row holds all neighbors of its particle.
NeighborList full_list(const NeighborList& half);

/// Mixes what stands now into the running means, but for idle particles, which keep theirs. Pairs
/// count as contacts up to a gap of three mean overlaps, with the stiffness of at least a mean
/// overlap: they may close at any time. Loads and velocities must be those of the present places.
void renew_stiffness(const NeighborList& full, const PeriodicCell& cell, const Material& material,
                     double mean_overlap, const Particles& particles, const ActiveParticles& active,
                     ContactStiffness& stiffness);

/// M = 3 K + floor, and for the cell three times its sum. The floor is a hundredth of the typical
/// stiffness, but three times it for particles with fewer than four contacts, which would knock
/// about otherwise. Sets the active particles' blocks; the others' mean nothing.
void set_metric(const ContactStiffness& stiffness, const Particles& particles,
                const ActiveParticles& active, RelaxationMetric& metric);

}  // namespace jam
