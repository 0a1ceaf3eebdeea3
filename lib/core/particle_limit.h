// SPDX-License-Identifier: BSD-3-Clause
// How many particles a packing can have.
#pragma once

#include "core/types.h"

namespace jam {

/// A listed neighbor is a place in 27 bits beside a periodic image (neighbor_list.h, whose source
/// checks it).
inline constexpr Count max_particle_count = Count{1} << 27;

}  // namespace jam
