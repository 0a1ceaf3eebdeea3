// SPDX-License-Identifier: BSD-3-Clause
// The strokes of the letters: a plain monoline alphabet made of straight lines and arcs.
#pragma once

#include "report/drawing.h"

#include <string_view>
#include <vector>

namespace jam {

/// Capitals and digits stand 7 units high on the base line y = 0 (y upwards), small letters 5.
inline constexpr double capital_height = 7.0;
inline constexpr double pen_width = 0.92;
inline constexpr double letter_gap = 1.75;

struct Letter {
    double width = 0.0;
    std::vector<std::vector<Spot>> strokes;  ///< in units, y upwards
};

/// The letter of a character; a box for one that the alphabet has not.
const Letter& letter(char character);

}  // namespace jam
