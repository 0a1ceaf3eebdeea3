// SPDX-License-Identifier: BSD-3-Clause
// Contacts of the backbone's particles against their size.
#pragma once

#include "analysis/bins.h"
#include "analysis/linear_fit.h"
#include "analysis/rattlers.h"
#include "analysis/table.h"

#include <span>

namespace jam {

struct SizeCoordinationSettings {
    int bins_per_decade = 20;
    double fit_from = 0.05;  ///< the line is fitted to bins with (D/lambda)^2 at least this
};

/// Z(D) - 3, the mean number of contacts beyond the three that hold a particle, by diameter, and
/// the line that it follows for large particles: Z - 3 = intercept + slope (D/lambda)^2 (Monti et
/// al., Fig. 6). D/lambda is taken as D / max D. One entry a bin that holds a particle of the
/// backbone.
struct SizeCoordination {
    std::vector<double> diameters;        ///< mean of the bin's particles
    std::vector<double> scaled_areas;     ///< mean (D / max D)^2 of the bin's particles
    std::vector<double> excess_contacts;  ///< mean Z - 3
    std::vector<double> errors;           ///< standard error of it; not a number for one particle
    std::vector<Count> particle_counts;
    LinearFit fit;  ///< weighted by the errors; bins of one particle do not count
};

/// `diameters` of all particles, length N, as `rattlers`.
SizeCoordination size_coordination(std::span<const double> diameters, const Rattlers& rattlers,
                                   const SizeCoordinationSettings& settings = {});

/// Columns diameter, scaled_area, excess_contacts, error, particles.
Table table(const SizeCoordination& coordination);

}  // namespace jam
