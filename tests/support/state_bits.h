// SPDX-License-Identifier: BSD-3-Clause
// One number for the particles, the cell and the pressure of a run.
#pragma once

#include "jamming/jam_state.h"

#include <cstdint>

namespace jam::test {

/// Equal for two states of the same bits.
std::uint64_t bits_of(const JamState& state);

}  // namespace jam::test
