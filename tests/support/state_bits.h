// SPDX-License-Identifier: BSD-3-Clause
// One number for all that a run's next step depends on.
#pragma once

#include "jamming/jam_state.h"

#include <cstdint>

namespace jam::test {

/// Equal for two states of the same bits.
std::uint64_t bits_of(const JamState& state);

}  // namespace jam::test
