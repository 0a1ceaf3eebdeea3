// SPDX-License-Identifier: BSD-3-Clause
// The figures of one packing that are about sizes. Numbers of figures are those of Monti et al.
#pragma once

#include "analysis/backbone_sizes.h"
#include "analysis/contact_numbers.h"
#include "analysis/contact_pair_sizes.h"
#include "analysis/measured_sizes.h"
#include "analysis/size_coordination.h"
#include "report/figure.h"

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

}  // namespace jam
