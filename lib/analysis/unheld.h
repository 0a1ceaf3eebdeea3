// SPDX-License-Identifier: BSD-3-Clause
// A stricter test for rattlers: enough contacts, but all on one side.
#pragma once

#include "analysis/rattlers.h"

#include <span>

namespace jam {

/// Whether some plane through the origin has all `directions` (unit vectors) on one side of it or
/// within it. A sphere whose contacts do is free to move away from them, or buckles; fewer than
/// four always do. Directions within 1e-8 rad of a plane count as within it.
bool within_half_space(std::span<const Vec3> directions);

/// Removes particles whose contacts lie within one half-space, and so takes contacts from their
/// partners, until every particle left is held from all sides (Donev et al., 2004). The result does
/// not depend on the order of removal. Meant for packings at rest: where forces do not balance, who
/// leans to one side falls first and an avalanche may take all.
Rattlers find_unheld(std::span<const Contact> contacts, const ContactRows& rows);

}  // namespace jam
