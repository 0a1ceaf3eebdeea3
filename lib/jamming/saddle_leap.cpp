// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/saddle_leap.h"

#include "jamming/active_particles.h"

#include <algorithm>

namespace jam {

namespace {

constexpr double most_times = 50.0;

/// Fractional, by the nearest way.
Vec3 displacement_since(const LeapReference& reference, const Particles& particles, std::size_t i) {
    const Vec3 moved = particles.spheres[i].center - reference.centers[particles.ids[i]];
    return moved - moved.array().round().matrix();
}

}  // namespace

LeapReference leap_reference(const Particles& particles, double cundall) {
    LeapReference reference{cundall, std::vector<Vec3>(particles.spheres.size())};
    for (std::size_t i = 0; i < particles.spheres.size(); ++i)
        reference.centers[particles.ids[i]] = particles.spheres[i].center;
    return reference;
}

double leap(const LeapReference& reference, const PeriodicCell& cell, double longest,
            Particles& particles) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < particles.spheres.size(); ++i) {
        if (!touches_another(particles, i)) continue;
        const Vec3 moved = cell.cartesian(displacement_since(reference, particles, i));
        farthest = std::max(farthest, moved.norm());
    }
    if (farthest == 0.0) return 0.0;
    const double times = std::min(most_times, longest / farthest);
    for (std::size_t i = 0; i < particles.spheres.size(); ++i)
        if (touches_another(particles, i))
            particles.spheres[i].center += times * displacement_since(reference, particles, i);
    return times;
}

}  // namespace jam
