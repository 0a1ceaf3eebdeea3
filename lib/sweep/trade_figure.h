// SPDX-License-Identifier: BSD-3-Clause
// The trade of speed for accuracy as a figure.
#pragma once

#include "report/figure.h"
#include "sweep/trade.h"

namespace jam {

/// Errors of phi and of Z_nr against the evaluations of each choice, with their fronts: the figure
/// "trade". Choices without an error (the reference among them) are left out.
Figure trade_figure(std::span<const TradePoint> points);

}  // namespace jam
