// SPDX-License-Identifier: BSD-3-Clause
// Which particles bear no load: those with too few contacts, taken away again and again until none
// is left.
#pragma once

#include "analysis/contact_network.h"

#include <cstdint>
#include <span>
#include <vector>

namespace jam {

/// The paper's rule (Monti et al.): a particle held by fewer contacts is a rattler. Others use 4.
inline constexpr int default_rattler_threshold = 3;
/// Without friction three contacts hold a sphere only in their own plane.
inline constexpr int contacts_that_hold = 4;

/// What is left when the rattlers are gone is the backbone.
struct Rattlers {
    std::vector<std::uint8_t> is_rattler;  ///< size N; 1: rattler, 0: in the backbone
    std::vector<int> contact_counts_nr;    ///< size N; contacts within the backbone, 0 for rattlers
    Count rattler_count = 0;
    Count contact_count_nr = 0;  ///< contacts with both particles in the backbone

    Count backbone_count() const { return static_cast<Count>(is_rattler.size()) - rattler_count; }
    bool bears(const Contact& contact) const {
        return is_rattler[contact.first] == 0 && is_rattler[contact.second] == 0;
    }
};

/// Fills in, from is_rattler, everything that follows from it.
void count_backbone(std::span<const Contact> contacts, const ContactRows& rows, Rattlers& rattlers);

/// Removes particles with fewer than `threshold` contacts, and so takes contacts from their
/// partners, until every particle left has at least `threshold` (Donev et al., 2004). The result
/// does not depend on the order of removal: it is the largest set in which all have enough. Time
/// O(N_c).
Rattlers find_rattlers(std::span<const Contact> contacts, const ContactRows& rows,
                       int threshold = default_rattler_threshold);

}  // namespace jam
