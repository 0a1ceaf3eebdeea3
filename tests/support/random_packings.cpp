// SPDX-License-Identifier: BSD-3-Clause
#include "support/random_packings.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>

namespace jam::test {

namespace {

/// Uniform numbers one after the other.
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : seed_(seed) {}
    double next(double low = 0.0, double high = 1.0) {
        return low + (high - low) * uniform(seed_, RandomStream::tests, next_++);
    }

  private:
    std::uint64_t seed_;
    std::uint64_t next_ = 0;
};

PeriodicCell random_cell(Numbers& numbers, double volume, const RandomPackingSettings& settings,
                         double largest_diameter) {
    Mat3 h = Mat3::Zero();
    for (int k = 0; k < 3; ++k) h(k, k) = numbers.next(0.8, 1.25);
    h(0, 1) = h(0, 0) * settings.largest_tilt * numbers.next(-1.0, 1.0);
    h(0, 2) = h(0, 0) * settings.largest_tilt * numbers.next(-1.0, 1.0);
    h(1, 2) = h(1, 1) * settings.largest_tilt * numbers.next(-1.0, 1.0);
    h *= std::cbrt(volume / h.diagonal().prod());
    const double width = PeriodicCell(h).perpendicular_widths().minCoeff();
    return PeriodicCell(Mat3(h * std::max(1.0, settings.least_width * largest_diameter / width)));
}

}  // namespace

RandomPacking random_packing(std::uint64_t seed, const RandomPackingSettings& settings) {
    Numbers numbers(seed);
    RandomPacking packing;
    Particles& particles = packing.particles;
    double volume = 0.0;
    for (int i = 0; i < settings.count; ++i) {
        const double place = i == 0 ? 1.0 : i == 1 ? 0.0 : numbers.next();
        const double diameter = std::pow(settings.size_ratio, place);
        volume += sphere_volume(diameter);
        const Vec3 center(numbers.next(-1.0, 2.0), numbers.next(), numbers.next(-0.5, 1.0));
        const Vec3 velocity(numbers.next(-0.1, 0.1), numbers.next(-0.1, 0.1),
                            numbers.next(-0.1, 0.1));
        particles.spheres.push_back({center, diameter});
        particles.motions.push_back({velocity, sphere_volume(diameter)});
        particles.loads.push_back({Vec3::Zero(), 0.0});
        particles.ids.push_back(static_cast<std::uint32_t>(i));
    }
    packing.cell =
        random_cell(numbers, volume / settings.volume_fraction, settings, settings.size_ratio);
    return packing;
}

std::vector<double> diameters_of(const Particles& particles) {
    std::vector<double> diameters;
    for (const Sphere& sphere : particles.spheres) diameters.push_back(sphere.diameter);
    return diameters;
}

}  // namespace jam::test
