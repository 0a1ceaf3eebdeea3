// SPDX-License-Identifier: BSD-3-Clause
// What all particles of a packing are made of.
#pragma once

namespace jam {

/// Normal force of two overlapping spheres without friction.
enum class ContactLaw {
    hooke,  ///< F = k overlap (Monti et al., Eq. 1)
    hertz,  ///< F = k sqrt(R_eff overlap) overlap, R_eff = R_i R_j / (R_i + R_j), k in units of
            ///< pressure
};

/// The defaults are the paper's.
struct Material {
    ContactLaw law = ContactLaw::hooke;
    double stiffness = 1.0;  ///< k: force/length (hooke) or pressure (hertz)
    double damping = 0.5;    ///< gamma of the force -M_eff gamma v_n, 1/time
    double density = 1.0;    ///< mass/volume
};

}  // namespace jam
