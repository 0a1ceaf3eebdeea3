// SPDX-License-Identifier: BSD-3-Clause
// The figures of one packing.
#pragma once

#include "report/figure.h"
#include "report/measurements.h"

#include <vector>

namespace jam {

/// All figures (size_figures.h, pair_figures.h, history_figure.h) that say something about this
/// packing. `history` may be empty.
std::vector<Figure> packing_figures(const Measurements& measurements, const Table& history);

}  // namespace jam
