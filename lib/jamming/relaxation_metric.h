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

#include <array>
#include <vector>

namespace jam {

/// A symmetric 3x3 matrix.
struct SymmetricBlock {
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

/// What the contacts around a particle resist.
struct alignas(64) ParticleStiffness {
    SymmetricBlock block;   ///< sum over contacts of k n n^T, a running mean
    double contacts = 0.0;  ///< how many there were at the last renewal
};

/// The same of all, by id, and of the cell: running means, which belong to a run's state.
struct ContactStiffness {
    std::vector<ParticleStiffness> particles;
    double typical = 0.0;      ///< k of a contact in the mean
    Mat3 cell = Mat3::Zero();  ///< component (a, b): sum over contacts of k n_a^2 r_b^2

    bool empty() const { return particles.empty(); }
};

/// The inverse of a particle's block M.
struct alignas(64) BlockResponse {
    SymmetricBlock inverse;
    double mass = 1.0;  ///< a third of the trace of M
};

/// The same of four particles.
struct QuadResponse {
    Double4 xx, xy, xz, yy, yz, zz, mass;

    /// M^-1 f.
    Columns4 operator()(const Columns4& f) const {
        return {xx * f.x + xy * f.y + xz * f.z, xy * f.x + yy * f.y + yz * f.z,
                xz * f.x + yz * f.y + zz * f.z, Double4{}};
    }
};

inline QuadResponse load_responses(const std::vector<BlockResponse>& responses, const Quad& quad) {
    const std::array<Double4, 2> a = load8(responses[quad.at[0]]);
    const std::array<Double4, 2> b = load8(responses[quad.at[1]]);
    const std::array<Double4, 2> c = load8(responses[quad.at[2]]);
    const std::array<Double4, 2> d = load8(responses[quad.at[3]]);
    const Columns4 first = transposed({a[0], b[0], c[0], d[0]});
    const Columns4 second = transposed({a[1], b[1], c[1], d[1]});
    return {first.x, first.y, first.z, first.w, second.x, second.y, second.z};
}

struct RelaxationMetric {
    std::vector<BlockResponse> particles;  ///< by place in the arrays
    std::vector<char> stands;              ///< whether a particle's has been set
    std::vector<Count> set_of_block;       ///< active ones of a block whose has been set
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
/// about otherwise. Sets the active particles' blocks that do not stand yet: none does after
/// forget_metric, which goes before it when the stiffness is renewed or the particles are sorted.
void forget_metric(const Particles& particles, RelaxationMetric& metric);
void set_metric(const ContactStiffness& stiffness, const Particles& particles,
                const ActiveParticles& active, RelaxationMetric& metric);

}  // namespace jam
