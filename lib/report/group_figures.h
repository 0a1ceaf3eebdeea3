// SPDX-License-Identifier: BSD-3-Clause
// The figures of many packings. Numbers of figures are those of Monti et al.
#pragma once

#include "report/figure.h"
#include "report/packing_groups.h"

#include <vector>

namespace jam {

/// Fig. 3: volume fraction against alpha, with the rod model's prediction.
Figure volume_fraction_figure(std::span<const PackingGroup> groups);

/// Fig. 5: coordination and rattlers against alpha.
Figure coordination_figure(std::span<const PackingGroup> groups);

/// Fig. 7: the backbone's volume fraction against alpha.
Figure backbone_volume_fraction_figure(std::span<const PackingGroup> groups);

/// Fig. 9: backbone particles larger than a size, a panel an alpha.
Figure larger_by_size_ratio_figure(std::span<const NamedMeasurements> packings,
                                   std::span<const PackingGroup> groups);

/// Fig. 9, inset: where small particles begin to matter, against alpha.
Figure onset_figure(std::span<const PackingGroup> groups);

/// Figs 6 and 8 for every alpha of the largest size ratio.
Figure size_coordination_by_alpha_figure(std::span<const NamedMeasurements> packings,
                                         std::span<const PackingGroup> groups);
Figure backbone_sizes_by_alpha_figure(std::span<const NamedMeasurements> packings,
                                      std::span<const PackingGroup> groups);

/// All of the above; nothing unless there is a group that follows a power law.
std::vector<Figure> group_figures(std::span<const NamedMeasurements> packings,
                                  std::span<const PackingGroup> groups);

}  // namespace jam
