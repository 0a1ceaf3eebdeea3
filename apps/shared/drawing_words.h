// SPDX-License-Identifier: BSD-3-Clause
// What a user is told of figures that could not be drawn.
#pragma once

#include "report/figure.h"

namespace jam::apps {

/// On standard error; nothing if all were drawn.
void tell_of_drawing(const Drawing& drawing);

}  // namespace jam::apps
