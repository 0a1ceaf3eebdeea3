// SPDX-License-Identifier: BSD-3-Clause
// The three ways to find near pairs that Monti et al. compare, by their names there. They list the
// same pairs; they differ in what that costs at wide size ratios.
#pragma once

#include "grids/size_collections.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace jam {

enum class NeighborMethod : std::uint8_t {
    multi,      ///< a grid for each collection; searched from the smaller to the larger
    multi_old,  ///< one grid sized by the smallest; a stencil for each pair of collections
    one_grid,   ///< "default": one grid sized by the largest; cost grows as lambda^3
};

struct NamedNeighborMethod {
    std::string_view name;
    NeighborMethod method;
};
inline constexpr std::array<NamedNeighborMethod, 3> neighbor_methods{{
    {"default", NeighborMethod::one_grid},
    {"multi-old", NeighborMethod::multi_old},
    {"multi", NeighborMethod::multi},
}};

}  // namespace jam
