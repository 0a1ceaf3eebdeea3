// SPDX-License-Identifier: BSD-3-Clause
// The last stretch to mechanical equilibrium: Newton's method on the enthalpy, for packings that
// are nearly at rest. It ends in balance, to round-off, in a few steps; at a saddle if it began at
// one.
//
// Each step minimises the enthalpy with its geometry made linear (contact_model.h), in which
// contacts open and close; a plain Newton step would be cut short at the first that does. Where the
// curvature is negative (particles about to buckle) damping in proportion to the prestress is added
// until it is not (Levenberg, 1944; Marquardt, 1963).
#pragma once

#include "jamming/jam_state.h"

namespace jam {

struct NewtonSettings {
    Material material;
    double pressure = 0.0;  ///< applied, isotropic; the cell is free in all six components
    double cundall = 1e-8;  ///< to be reached, and the same for the error of the six pressures
    int most_factorizations = 100;
    double most_operations = 2e11;  ///< of one factorization: beyond it nothing is tried
    double largest_window = 0.05;   ///< gap up to which pairs take part, in smallest diameters
};

struct NewtonResult {
    bool tried = false;      ///< false: a factorization would have taken too long
    bool converged = false;  ///< in balance; damped, so whether it stands is another question
    int steps = 0;
    int factorizations = 0;   ///< also of a descent that was given up
    double operations = 0.0;  ///< floating-point ones of one factorization
    double cundall = 0.0;
    double pressure_error = 0.0;
};

/// Moves particles and cell to the balance nearby; where it is not reached they stay as they are.
/// It is given up early where two steps have not brought the damping down: somebody is about to
/// buckle, and goes farther than the window. `candidates` must hold every pair within the window.
/// Particles keep their places in the arrays, and no particle moves by more than the window, so the
/// list stays good. On one thread.
NewtonResult newton_relax(const NewtonSettings& settings, const NeighborList& candidates,
                          double smallest_diameter, PeriodicCell& cell, Particles& particles);

}  // namespace jam
