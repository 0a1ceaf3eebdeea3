// SPDX-License-Identifier: BSD-3-Clause
// Which sizes bear load.
#pragma once

#include "analysis/bins.h"
#include "analysis/rattlers.h"
#include "analysis/table.h"

#include <span>

namespace jam {

struct BackboneSizesSettings {
    int bins_per_decade = 20;
    double onset_threshold = 0.99;  ///< of F, in (0, 1); sharper the closer to 1
};

/// The size distribution of the backbone's particles beside that of all (Monti et al., Figs 8, 9).
struct BackboneSizes {
    Bins bins;
    std::vector<double> density;     ///< P(D) of all particles, per unit of diameter
    std::vector<double> density_nr;  ///< P_nr(D) of the backbone
    std::vector<double> larger_nr;   ///< F: fraction of the backbone with a diameter above
                                     ///< bins.edges[b], one an edge
    /// M: where F(D/lambda) first falls below the threshold, as D / max D; the smallest size that
    /// matters to the backbone. Not a number without a backbone.
    double onset = 0.0;
    double effective_size_ratio = 0.0;  ///< lambda* = 1 / M
};

/// `diameters` of all particles, length N, as `rattlers`. Throws InputError for a threshold outside
/// (0, 1).
BackboneSizes backbone_sizes(std::span<const double> diameters, const Rattlers& rattlers,
                             const BackboneSizesSettings& settings = {});

/// Columns diameter_low, diameter_high, density, density_nr: a row a bin.
Table density_table(const BackboneSizes& sizes);

/// Columns scaled_diameter (D / max D), larger_nr: a row an edge.
Table larger_table(const BackboneSizes& sizes);

}  // namespace jam
