// SPDX-License-Identifier: BSD-3-Clause
// Many packings, put together by the sizes they were made from and averaged over the rest: seeds.
#pragma once

#include "analysis/bootstrap.h"
#include "report/measurements.h"
#include "sizes/size_distribution.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace jam {

/// What a packing's sizes are called in a report.
struct SizesName {
    std::string words;            ///< "λ = 10, α = 0.55"; the same for all of a group
    std::optional<PowerLaw> law;  ///< where they follow a power law
};

/// By what the packing was made from, where that is known.
SizesName name_of(const SizeDistribution& sizes);

/// By what is found: equal spheres; a power law, its size ratio a round number up to 3 % above that
/// found and its alpha rounded to a twentieth; or, where the cumulative volume is more than 0.05
/// from the law's, other sizes.
SizesName name_of(const Measurements& measurements);

struct NamedMeasurements {
    std::string name;  ///< of the packing
    SizesName sizes;
    Measurements measurements;
};

/// Estimates are means over the packings; errors from bootstrap.
struct PackingGroup {
    SizesName sizes;
    std::vector<int> members;  ///< places in the packings it was made from
    Estimate volume_fraction;
    Estimate volume_fraction_nr;
    Estimate coordination;
    Estimate coordination_nr;
    Estimate rattler_fraction;
    Estimate onset;  ///< M of Fig. 9
};

/// Groups by the words of the sizes: power laws first, by size ratio, then by alpha.
std::vector<PackingGroup> group_packings(std::span<const NamedMeasurements> packings);

/// A row a group that follows a power law: columns size_ratio, alpha, packings, and each estimate
/// with its error, the latter named NAME_error.
Table groups_table(std::span<const PackingGroup> groups);

}  // namespace jam
