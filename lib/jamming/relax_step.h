// SPDX-License-Identifier: BSD-3-Clause
// One step of the relaxation of the enthalpy U(x, h) + p V in positions and cell together: motion
// with little friction, and forces that look ahead, in the metric of relaxation_metric.h.
#pragma once

#include "contacts/contact_forces.h"
#include "core/stage_times.h"
#include "jamming/active_particles.h"
#include "jamming/jam_state.h"
#include "neighbors/verlet_lists.h"

namespace jam {

struct RelaxSettings {
    Material material;
    Mat3 pressure = Mat3::Zero();  ///< applied; symmetric
    FreeCell free_cell = FreeCell::all;
    /// In the metric's units, in which no mode is faster than w^2 = 2/3 where contacts are as many
    /// and as stiff as when it was renewed. Stable while time_step (time_step + 2 look_ahead) w^2 <
    /// 4: stiffness may double meanwhile.
    double time_step = 1.2;
    double look_ahead = 0.6;       ///< of the forces, in the same units
    double largest_move = 0.02;    ///< of a particle in a step, in smallest diameters
    double largest_strain = 1e-3;  ///< of the cell in a step
};

/// Overlap of two of the smallest spheres that goes with a pressure, in their diameters: modes as
/// slow as buckling turn over in 1 / sqrt of it, in the metric's units.
double relative_overlap(const Material& material, double pressure, double smallest_diameter);

/// Memory of the steps, kept between them.
struct RelaxScratch {
    RelaxScratch(std::span<const double> diameters, const ListSettings& settings)
        : lists(diameters, settings) {}

    VerletLists lists;
    NeighborList full;  ///< of lists.candidates
    RelaxationMetric metric;
    ActiveParticles active;  ///< while lists.tiles stand
    ForceScratch forces;
    ContactSums sums;
    double net_force = 0.0;  ///< sum over particles of |F|
    StepMotion motion;
    StageTimes times;

    /// Of the last evaluation; NaN without contacts.
    double cundall() const { return net_force / sums.force_magnitudes; }
};

/// Lists, forces and metric for state.particles as they stand: at the beginning of a relaxation,
/// and when one goes on from a checkpoint. Called once before the first step.
void begin_relaxation(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch);

/// One step, one evaluation of the forces. state.particles are sorted anew whenever the lists are;
/// afterwards loads, pressure and scratch belong to the state as it is.
void relax_step(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch);

}  // namespace jam
