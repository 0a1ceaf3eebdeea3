// SPDX-License-Identifier: BSD-3-Clause
// How stiff a packing is.
#pragma once

#include "analysis/hessian.h"

#include <limits>

namespace jam {

/// Linear response to a small strain of the cell, the particles following to their new equilibrium.
struct ElasticModuli {
    /// d stress / d strain in Voigt's order with engineering shears, at the pressure of the Hessian
    /// (the stress-strain coefficients of Barron and Klein, Proc. Phys. Soc. 85, 523, 1965).
    Mat6 stiffness = Mat6::Constant(std::numeric_limits<double>::quiet_NaN());
    /// The same if every particle followed the cell's strain exactly.
    Mat6 affine = stiffness;
    /// K = -V dp/dV = (1/9) sum of C_ab over a, b <= 3. Force/length^2.
    double bulk = std::numeric_limits<double>::quiet_NaN();
    /// G, averaged over all orientations of a strain (Voigt): (C_11 + C_22 + C_33 - C_12 - C_23 -
    /// C_13) / 15 + (C_44 + C_55 + C_66) / 5.
    double shear = std::numeric_limits<double>::quiet_NaN();
};

/// All not a number unless the packing is stable: one that falls has no modulus. Throws InputError
/// if memory does not suffice. Time as find_stability.
ElasticModuli elastic_moduli(const EnthalpyHessian& hessian);

}  // namespace jam
