// SPDX-License-Identifier: BSD-3-Clause
// How far apart two spheres may be and still be listed.
#pragma once

namespace jam {

/// A pair is listed up to (D_i + D_j)/2 (1 + strain_margin) + 2 skin. The strain margin keeps a
/// list good while the cell deforms, the skin while particles move within it; they are kept apart
/// because a pair of large spheres feels strain in proportion to its size, and motion not.
struct InteractionReach {
    double strain_margin = 0.0;
    double skin = 0.0;

    /// One sphere's share; a pair's reach is the sum of two.
    double of(double diameter) const { return 0.5 * diameter * (1.0 + strain_margin) + skin; }
    template <typename Number>
    Number of(const Number& diameter_i, const Number& diameter_j) const {
        return 0.5 * (diameter_i + diameter_j) * (1.0 + strain_margin) + 2.0 * skin;
    }
};

}  // namespace jam
