// SPDX-License-Identifier: BSD-3-Clause
// The figure of a run over time.
#pragma once

#include "report/figure.h"

namespace jam {

/// Fig. 2 of Monti et al.: a run over time, from read_run_history. `applied_pressure` 0: not known.
Figure history_figure(const Table& history, double applied_pressure);

}  // namespace jam
