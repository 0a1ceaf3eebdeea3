// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/particle_count.h"

#include "core/check.h"

#include <cmath>

namespace jam {

namespace {

double count_by_rule(const SizeDistribution& sizes) {
    const double threshold = 0.95 * largest_diameter(sizes);
    const double above = 1.0 - cumulative_fraction(sizes, Weight::number, threshold);
    return std::ceil(10.1 / above);
}

double wanted_count(const Binary& binary) {
    const double volume_ratio = std::pow(binary.size_ratio, 3);
    const double large = static_cast<double>(binary.large_count);
    return large +
           std::round(large * volume_ratio * binary.small_fraction / (1.0 - binary.small_fraction));
}

double wanted_count(const DiameterList& list) {
    return static_cast<double>(list.diameters.size());
}

double wanted_count(const Monodisperse&) {
    throw InputError(
        "sizes.count: missing; equal spheres have no rule for their number, give one, for "
        "example sizes.count = 10000");
}

double wanted_count(const auto& continuous) {
    return count_by_rule(continuous);
}

std::string_view remedy(const SizeDistribution& sizes) {
    if (std::holds_alternative<Binary>(sizes))
        return "lower sizes.large_count, sizes.size_ratio or sizes.small_fraction";
    if (std::holds_alternative<DiameterList>(sizes)) return "give sizes.count";
    return "lower sizes.size_ratio, choose sizes with more large particles, or give sizes.count";
}

}  // namespace

void check_particle_count(Count count) {
    require(count >= 1 && count <= max_particle_count,
            "sizes.count = {}: must be from 1 to {}; give a number in that range", count,
            max_particle_count);
}

Count particle_count(const SizeDistribution& sizes) {
    const double count = std::visit([](const auto& kind) { return wanted_count(kind); }, sizes);
    require(count <= static_cast<double>(max_particle_count),
            "sizes.count = {:.4g}, as follows from the other keys of [sizes]: must be at most {}; "
            "{}",
            count, max_particle_count, remedy(sizes));
    return static_cast<Count>(count);
}

}  // namespace jam
