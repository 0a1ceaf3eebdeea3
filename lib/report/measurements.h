// SPDX-License-Identifier: BSD-3-Clause
// Everything that a report says of one packing.
#pragma once

#include "analysis/backbone_sizes.h"
#include "analysis/contact_numbers.h"
#include "analysis/contact_pair_sizes.h"
#include "analysis/elasticity.h"
#include "analysis/force_distribution.h"
#include "analysis/gap_distribution.h"
#include "analysis/measured_sizes.h"
#include "analysis/packing_statistics.h"
#include "analysis/radial_distribution.h"
#include "analysis/size_coordination.h"
#include "sizes/rod_packing.h"

#include <optional>
#include <string>

namespace jam {

/// The rod model with the gap factor that gives equal spheres 0.639, as the protocol of Monti et
/// al. does.
inline constexpr RodModel rod_model_of_reports{0.780};

struct Measurements {
    PackingStatistics statistics;
    Mat3 applied_pressure = Mat3::Zero();  ///< zero where it is not known
    double rod_fraction = 0.0;             ///< volume fraction by rod_model_of_reports
    CumulativeVolume cumulative_volume;
    SizePowerLaw power_law;
    ContactPairSizes pair_sizes;
    SizeCoordination size_coordination;
    ContactNumbers contact_numbers;
    BackboneSizes backbone_sizes;
    ForceDistribution forces;
    GapDistribution gaps;
    RadialDistribution radial;
    std::optional<Elasticity> elasticity;  ///< where it was asked for

    /// Whether there are several sizes: figures over size say something only then.
    bool polydisperse() const { return statistics.size_ratio > 1.0 + 1e-9; }
};

/// Throws InputError as find_contacts does.
Measurements measure(const Packing& packing, const ForceNetwork& network);

}  // namespace jam
