// SPDX-License-Identifier: BSD-3-Clause
// One time step at constant pressure and enthalpy, with a cell of up to six degrees of freedom
// (Parrinello and Rahman, 1981, written for the velocity gradient of the cell; no temperature
// anywhere).
//
// With h the cell matrix, s fractional positions, v = h ds/dt, L = dh/dt h^-1:
//   m dv/dt = F - m L^T v
//   W dL/dt = V (P_int - P_a) - W Gamma L        (upper triangle)
//   P_int = (sum m v v^T + sum over contacts f r^T) / V
// Without damping, kinetic energy + elastic energy + W L:L / 2 + p_a V is conserved.
#pragma once

#include "contacts/contact_forces.h"
#include "core/stage_times.h"
#include "jamming/jam_state.h"
#include "neighbors/verlet_lists.h"

#include <vector>

namespace jam {

/// Settings of the integrator, in the scene's own units.
struct NphSettings {
    Material material;
    Mat3 applied_pressure = Mat3::Zero();
    FreeCell free_cell = FreeCell::all;
    double time_step = 0.0;
    double cell_inertia = 0.0;  ///< W, mass x length^2
    double cell_damping = 0.0;  ///< Gamma, 1/time
};

/// Time step, inertia and damping as the scene says or chosen from N, k and D:
/// W = sum m D^2, so that a contact moves the cell as it moves its particles;
/// Gamma = sqrt(p V / W), the rate at which the applied pressure, acting alone, sets the cell in
/// motion; automatic time step: a quarter of the inverse of the highest frequency any particle can
/// have, from the most neighbors that fit around it, and under heavy damping at most 0.22 of the
/// stability limit.
NphSettings nph_settings(const Scene& scene, const JamState& state);

/// The largest time step that is stable whatever touches: 4 / (c + sqrt(c^2 + 4 w^2)), w the
/// highest frequency of any particle, c = 4 gamma the highest rate at which the damping forces of
/// equal neighbors slow one (leapfrog, damping forces half a step old: w^2 dt^2 + 2 c dt < 4). A
/// state with fewer contacts bears a longer step, up to twice as long.
double stability_limit(const Material& material, const Particles& particles);

/// The highest angular frequency of any particle that is surrounded by as many of the smallest ones
/// as fit.
double highest_frequency(const Material& material, const Particles& particles);

/// Memory of the steps, kept between them.
struct NphScratch {
    NphScratch(std::span<const double> diameters, const ListSettings& settings)
        : lists(diameters, settings) {}

    VerletLists lists;
    ForceScratch forces;
    ContactSums sums;
    StepMotion motion;
    StageTimes times;
};

/// Lists and forces for a state that has none yet, or that was read from a checkpoint; to be called
/// once before the first step.
void begin_nph(JamState& state, const NphSettings& settings, NphScratch& scratch);

/// One step. state.particles are sorted anew whenever the lists are.
void nph_step(JamState& state, const NphSettings& settings, NphScratch& scratch);

/// The conserved quantity of the undamped equations, plus what damping has not yet taken: for tests
/// and for the check of the time step. For an isotropic applied pressure.
double enthalpy(const JamState& state, const NphSettings& settings, const NphScratch& scratch);

}  // namespace jam
