// SPDX-License-Identifier: BSD-3-Clause
// The contacts of a packing: every pair of spheres that overlap, with its force.
#pragma once

#include "packing/packing.h"

#include <vector>

namespace jam {

/// Spheres `first` < `second` (places in the packing's arrays; equal for a sphere that touches its
/// own image) that overlap through `image`: r = x_first - x_second - h image, |r| < (D1 + D2) / 2.
struct Contact {
    Index first;
    Index second;
    Image image;
    double overlap;  ///< (D1 + D2) / 2 - |r|, above zero
    double force;    ///< elastic normal force, from the packing's material
    Vec3 normal;     ///< unit vector from second to first
};

/// All contacts, sorted by (first, second, image). Throws InputError if the cell is too small for
/// the largest sphere (a perpendicular width below the largest diameter).
std::vector<Contact> find_contacts(const Packing& packing);

}  // namespace jam
