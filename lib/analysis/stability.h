// SPDX-License-Identifier: BSD-3-Clause
// Whether a packing stands: the softest way in which it can give.
#pragma once

#include "analysis/hessian.h"

#include <limits>
#include <vector>

namespace jam {

struct StabilitySettings {
    FreeStrains free_strains = all_strains();
    /// A way to give counts as stiff if its eigenvalue is above this part of the mean diagonal of
    /// the displacements; round-off is some 1e-14 of it.
    double tolerance = 1e-10;
};

/// The smallest eigenvalue of the bordered matrix, translations left out, and its eigenvector.
struct Stability {
    bool stable = false;  ///< every eigenvalue is above the tolerance
    /// Force/length; not a number without particles. Below zero the packing falls along the mode.
    double smallest_eigenvalue = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> mode;  ///< displacement of hessian.particles; with the strain of norm 1
    Vec6 mode_strain = Vec6::Zero();  ///< strain of the cell, times hessian.strain_length
};

/// By Cholesky factors at growing shifts until one succeeds, and Lanczos iterations with its
/// inverse (Lanczos, 1950; Ericsson and Ruhe, Math. Comput. 35, 1251, 1980). A rattler among the
/// particles is a zero eigenvalue, so leave them out. Time and memory are those of the factor:
/// about N^2 and N^(4/3).
Stability find_stability(const EnthalpyHessian& hessian, const StabilitySettings& settings = {});

}  // namespace jam
