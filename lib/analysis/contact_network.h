// SPDX-License-Identifier: BSD-3-Clause
// The contacts of a packing: every pair of spheres that overlap, with its force.
#pragma once

#include "analysis/near_spheres.h"
#include "packing/packing.h"

#include <span>
#include <vector>

namespace jam {

/// Spheres `first` < `second` (places in the packing's arrays) that overlap through `image`:
/// r = h (s_first - s_second - image) with |r| < (D1 + D2) / 2, where h and s are those of
/// wrap_spheres. In a small cell one pair may touch through several images.
struct Contact {
    Index first;
    Index second;
    Image image;
    double overlap;  ///< (D1 + D2) / 2 - |r|, above zero
    double force;    ///< elastic normal force, from the packing's material
    Vec3 normal;     ///< unit vector from second to first
};

/// All contacts, sorted by (first, second, image). Throws InputError if the cell, its tilts
/// reduced, is too small for the largest sphere (a perpendicular width below the largest diameter).
std::vector<Contact> find_contacts(const Packing& packing);

/// One end of a contact: which contact, and whether the particle is its first or its second.
class ContactEnd {
  public:
    ContactEnd() = default;
    ContactEnd(Count contact, bool is_second)
        : word_(static_cast<std::uint32_t>(contact) << 1 | static_cast<std::uint32_t>(is_second)) {}

    Count contact() const { return word_ >> 1; }
    bool is_second() const { return (word_ & 1) != 0; }
    /// Direction of the force on this end's particle, given its contact's normal.
    double sign() const { return is_second() ? -1.0 : 1.0; }
    Index particle(std::span<const Contact> contacts) const {
        return is_second() ? contacts[contact()].second : contacts[contact()].first;
    }
    Index partner(std::span<const Contact> contacts) const {
        return is_second() ? contacts[contact()].first : contacts[contact()].second;
    }

  private:
    std::uint32_t word_ = 0;
};

/// Each particle's contact ends.
struct ContactRows {
    std::vector<Count> row_begin;  ///< size N + 1
    std::vector<ContactEnd> ends;  ///< size 2 N_c

    Index particle_count() const { return static_cast<Index>(row_begin.size()) - 1; }
    int contact_count(Index i) const { return static_cast<int>(row_begin[i + 1] - row_begin[i]); }
    std::span<const ContactEnd> row(Index i) const {
        return {ends.data() + row_begin[i], ends.data() + row_begin[i + 1]};
    }
};
ContactRows contact_rows(Index particle_count, std::span<const Contact> contacts);

}  // namespace jam
