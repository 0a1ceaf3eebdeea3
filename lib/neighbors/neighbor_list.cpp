// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/neighbor_list.h"

#include "core/particle_limit.h"

namespace jam {

static_assert(max_particle_count == Count{1} << Neighbor::index_bits);

namespace {

constexpr std::array<ImageShift, image_count> make_image_shifts() {
    std::array<ImageShift, image_count> shifts{};
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                shifts[image_code(x, y, z)] = {double(x), double(y), double(z), 0.0};
    return shifts;
}

}  // namespace

const std::array<ImageShift, image_count> image_shifts = make_image_shifts();

Image image_of(std::uint32_t code) {
    const ImageShift& shift = image_shifts[code];
    return {static_cast<std::int8_t>(shift.x), static_cast<std::int8_t>(shift.y),
            static_cast<std::int8_t>(shift.z)};
}

}  // namespace jam
