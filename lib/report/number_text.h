// SPDX-License-Identifier: BSD-3-Clause
// Numbers as a reader likes them.
#pragma once

#include "core/types.h"

#include <string>

namespace jam {

/// 1234567 as "1 234 567" (thin spaces).
std::string grouped(Count number);

/// Three digits: "0.0123", "4.57 × 10⁻⁷", "–" for not a number.
std::string short_number(double number);

/// Value and standard error with as many digits as the error has meaning: "0.7383(5)"; four
/// decimals without an error (not a number).
std::string with_error(double value, double error);

}  // namespace jam
