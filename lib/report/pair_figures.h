// SPDX-License-Identifier: BSD-3-Clause
// The figures of one packing that are about pairs: forces of contacts, gaps, distances.
#pragma once

#include "analysis/force_distribution.h"
#include "analysis/gap_distribution.h"
#include "analysis/radial_distribution.h"
#include "report/figure.h"

#include <span>

namespace jam {

/// Whether any bin holds enough to be drawn, of `forces.contact_counts` or `gaps.pair_counts`.
bool worth_drawing(std::span<const Count> counts);

Figure forces_figure(const ForceDistribution& forces);
Figure gaps_figure(const GapDistribution& gaps);
Figure radial_figure(const RadialDistribution& radial);

}  // namespace jam
