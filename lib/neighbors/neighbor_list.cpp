// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/neighbor_list.h"

namespace jam {

namespace {

constexpr std::array<ImageShift, Neighbor::image_count> make_image_shifts() {
    std::array<ImageShift, Neighbor::image_count> shifts{};
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                shifts[Neighbor::code_of(x, y, z)] = {double(x), double(y), double(z), 0.0};
    return shifts;
}

}  // namespace

const std::array<ImageShift, Neighbor::image_count> image_shifts = make_image_shifts();

Image image_of(std::uint32_t image_code) {
    const ImageShift& shift = image_shifts[image_code];
    return {static_cast<std::int8_t>(shift.x), static_cast<std::int8_t>(shift.y),
            static_cast<std::int8_t>(shift.z)};
}

}  // namespace jam
