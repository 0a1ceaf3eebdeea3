// SPDX-License-Identifier: BSD-3-Clause
// The elastic part of one contact: force and energy from the overlap alone.
#pragma once

#include "particles/material.h"

#include <cmath>

namespace jam {

/// Linear spring: F = k delta, U = k delta^2 / 2 (Monti et al., Eq. 1).
struct Hooke {
    double stiffness;

    double force(double overlap, double /*diameter_i*/, double /*diameter_j*/) const {
        return stiffness * overlap;
    }
    double energy(double overlap, double /*diameter_i*/, double /*diameter_j*/) const {
        return 0.5 * stiffness * overlap * overlap;
    }
    /// dF / d overlap
    double tangent(double /*overlap*/, double /*diameter_i*/, double /*diameter_j*/) const {
        return stiffness;
    }
};

/// Two elastic spheres: F = k sqrt(R_eff delta) delta, U = 2/5 F delta, with
/// R_eff = R_i R_j / (R_i + R_j) and k = 4/3 of the effective modulus (Hertz, 1882).
struct Hertz {
    double stiffness;

    static double effective_radius(double diameter_i, double diameter_j) {
        return 0.5 * diameter_i * diameter_j / (diameter_i + diameter_j);
    }
    double force(double overlap, double diameter_i, double diameter_j) const {
        return stiffness * std::sqrt(effective_radius(diameter_i, diameter_j) * overlap) * overlap;
    }
    double energy(double overlap, double diameter_i, double diameter_j) const {
        return 0.4 * force(overlap, diameter_i, diameter_j) * overlap;
    }
    double tangent(double overlap, double diameter_i, double diameter_j) const {
        return 1.5 * stiffness * std::sqrt(effective_radius(diameter_i, diameter_j) * overlap);
    }
};

/// Overlap at which two spheres of one diameter press with `force`.
inline double overlap_of_force(const Material& material, double force, double diameter) {
    if (material.law == ContactLaw::hooke) return force / material.stiffness;
    const double root = std::sqrt(Hertz::effective_radius(diameter, diameter));
    return std::pow(force / (material.stiffness * root), 2.0 / 3.0);
}

/// Calls use(law) with the law that the material names: the choice is made once, outside the loop.
template <typename Use>
auto with_elastic_law(const Material& material, Use&& use) {
    if (material.law == ContactLaw::hertz) return use(Hertz{material.stiffness});
    return use(Hooke{material.stiffness});
}

}  // namespace jam
