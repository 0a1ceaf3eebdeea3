// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/list_validity.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace jam {

double largest_displacement(const ListReference& reference, const PeriodicCell& now,
                            const Particles& particles) {
    const Mat3& h = now.matrix();
    const double squared = max_blocks(particles.size(), 4096, [&](Count begin, Count end) {
        double largest = 0.0;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            const Vec3 moved = h * (particles.spheres[i].center - reference.centers[i]);
            largest = std::max(largest, moved.squaredNorm());
        }
        return largest;
    });
    return std::sqrt(squared);
}

bool list_is_valid(const ListReference& reference, const PeriodicCell& now, double displacement) {
    const double shortening = worst_shortening(reference.cell, now);
    return shortening * (1.0 + reference.reach.strain_margin) >= 1.0 &&
           displacement <= shortening * reference.reach.skin;
}

}  // namespace jam
