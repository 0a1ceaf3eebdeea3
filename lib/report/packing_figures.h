// SPDX-License-Identifier: BSD-3-Clause
// The figures of one packing. Numbers of figures are those of Monti et al.
#pragma once

#include "report/figure.h"
#include "report/measurements.h"

#include <vector>

namespace jam {

/// Fig. 1a: volume below a diameter.
Figure cumulative_volume_figure(const CumulativeVolume& volume, const SizePowerLaw& law);

/// Fig. 4: which sizes touch which.
Figure pair_sizes_figure(const ContactPairSizes& sizes);

/// Fig. 6: contacts against size, and how many have how many.
Figure size_coordination_figure(const SizeCoordination& coordination, const ContactNumbers& numbers,
                                double fit_from);

/// Fig. 8: sizes of the backbone beside those of all.
Figure backbone_sizes_figure(const BackboneSizes& sizes, const SizePowerLaw& law);

/// Fig. 9: backbone particles larger than a size.
Figure backbone_larger_figure(const BackboneSizes& sizes);

Figure forces_figure(const ForceDistribution& forces);
Figure gaps_figure(const GapDistribution& gaps);
Figure radial_figure(const RadialDistribution& radial);

/// All of the above that say something about this packing. `history` may be empty.
std::vector<Figure> packing_figures(const Measurements& measurements, const Table& history);

}  // namespace jam
