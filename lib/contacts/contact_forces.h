// SPDX-License-Identifier: BSD-3-Clause
// The sum over contacts: loads on the particles, virial, energy.
#pragma once

#include "cell/periodic_cell.h"
#include "core/parallel.h"
#include "neighbors/live_tile.h"
#include "particles/material.h"
#include "particles/particles.h"

#include <span>
#include <vector>

namespace jam {

/// What one force evaluation adds up beside the loads. A virial is sum over contacts of f r^T, f
/// the force on the first particle and r the vector from the second to it; symmetric.
struct ContactSums {
    Mat3 virial = Mat3::Zero();          ///< elastic and damping forces
    Mat3 elastic_virial = Mat3::Zero();  ///< elastic forces alone
    double energy = 0.0;                 ///< elastic
    double force_magnitudes = 0.0;       ///< sum over contacts of |f|
    Count contacts = 0;

    ContactSums& operator+=(const ContactSums& other);
};

/// What the contact forces depend on beside positions.
struct ContactFlow {
    bool damped = false;
    /// Gradient of the cell's own flow, rate of strain and rotation: velocities of particles are
    /// relative to it, and two particles in contact meet with v_i - v_j + L r.
    Mat3 velocity_gradient = Mat3::Zero();
};

/// Memory of the force loop, kept between calls.
struct ForceScratch {
    struct Thread {
        std::vector<Sphere> spheres;  ///< of the participants: Cartesian center and diameter
        std::vector<Motion> motions;
        std::vector<Load> loads;
        /// By contact: from the second center to the first, and what follows from it.
        std::vector<double> x, y, z, squared, reach, diameter_first, closing, mass, inverse, energy,
            elastic, force;
        std::vector<TilePair> contacts;
        LiveTileScratch live;
    };
    PerThread<Thread> threads;
    std::vector<Load> slots;
    std::vector<ContactSums> sums_of_tile;
    std::vector<LiveTile> live_tiles;               ///< by tile
    std::vector<std::vector<Index>> woken_of_tile;  ///< particles that touch and were not stirred
};

/// Contact forces over the tiles. Writes the loads of every tile's own participants, and
/// scratch.slots; add_halo_loads must follow. The loads of particles that take part in no tile are
/// not touched: whoever makes new tiles sets them to zero.
///
/// F = (elastic force - M_eff gamma v_n) n, never attractive: zero where damping would pull
/// (Monti et al., Eq. 1 and the switch described with it).
ContactSums contact_forces(const PeriodicCell& cell, const Material& material,
                           const ContactFlow& flow, const ContactTiles& tiles,
                           const Particles& particles, std::vector<Load>& loads,
                           ForceScratch& scratch);

/// The same without damping for tiles most of whose particles rest: looks at their live pairs only
/// (LiveTile). After new tiles begin_live_tiles must have been called. `stirred` is by particle;
/// who is found to touch another without it is told in scratch.woken_of_tile, and must be stirred
/// before it moves; whoever stirs one tells stir_live_tiles.
ContactSums live_contact_forces(const PeriodicCell& cell, const Material& material,
                                const ContactTiles& tiles, std::span<const char> stirred,
                                const Particles& particles, std::vector<Load>& loads,
                                ForceScratch& scratch);

void begin_live_tiles(const ContactTiles& tiles, ForceScratch& scratch);

/// Has live tiles made anew for those that have been stirred since the last call.
void stir_live_tiles(const ContactTiles& tiles, std::span<const Index> newly_stirred,
                     ForceScratch& scratch);

/// Adds the slots that belong to the particles of one block of ContactTiles::particles_per_block.
void add_halo_loads(const ContactTiles& tiles, Count block, const std::vector<Load>& slots,
                    std::vector<Load>& loads);

/// The same for all blocks.
void add_halo_loads(const ContactTiles& tiles, const std::vector<Load>& slots,
                    std::vector<Load>& loads);

}  // namespace jam
