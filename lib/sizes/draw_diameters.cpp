// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/draw_diameters.h"

#include "core/parallel.h"
#include "core/random.h"

namespace jam {

std::vector<double> draw_diameters(const SizeDistribution& sizes, Count count, DrawMethod method,
                                   std::uint64_t seed) {
    check_particle_count(count);
    const auto fraction = [&](Count id) {
        if (method == DrawMethod::random)
            return uniform(seed, RandomStream::diameters, static_cast<std::uint64_t>(id));
        return (static_cast<double>(id) + 0.5) / static_cast<double>(count);
    };
    constexpr Count block_size = 4096;
    std::vector<double> diameters(static_cast<std::size_t>(count));
    for_each_block(count, block_size, [&](Count, Count begin, Count end) {
        for (Count id = begin; id < end; ++id)
            diameters[static_cast<std::size_t>(id)] = quantile(sizes, Weight::number, fraction(id));
    });
    return diameters;
}

}  // namespace jam
