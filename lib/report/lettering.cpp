// SPDX-License-Identifier: BSD-3-Clause
#include "report/lettering.h"

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace jam {

namespace {

/// A letter as drawn by hand: its width, then pen commands.
///   M x y            lift the pen and go there
///   L x y            line to there
///   A cx cy rx ry from to   arc of an ellipse, angles in degrees counter-clockwise from +x; a line
///                    joins it to where the pen was, unless the pen was lifted (`O` for that)
///   O cx cy rx ry from to   the same, begun with a lifted pen
struct Drawn {
    char character;
    double width;
    const char* commands;
};

constexpr std::array drawn_letters = {
    Drawn{' ', 2.2, ""},
    Drawn{'0', 4.2, "O 2.1 3.5 2.1 3.5 0 360"},
    Drawn{'1', 2.2, "M 0 5.5 L 2.2 7 L 2.2 0"},
    Drawn{'2', 4.0, "O 2 5.05 1.95 1.95 165 -35 L 0 0 L 4.1 0"},
    Drawn{'3', 4.0, "O 1.95 5.2 1.8 1.8 150 -90 A 1.95 1.75 2.05 1.75 90 -150"},
    Drawn{'4', 4.5, "M 3.4 0 L 3.4 7 L 0 1.9 L 4.6 1.9"},
    Drawn{'5', 4.0, "M 3.7 7 L 0.6 7 L 0.3 3.7 A 1.9 2.25 2.15 2.25 125 -150"},
    Drawn{'6', 4.1, "M 3.1 7 A 3.6 2.6 3.5 4 125 180 O 2.1 2.15 2.05 2.15 0 360"},
    Drawn{'7', 4.0, "M 0 7 L 4.1 7 L 1.2 0"},
    Drawn{'8', 4.1, "O 2.05 5.25 1.75 1.75 0 360 O 2.05 1.75 2.05 1.75 0 360"},
    Drawn{'9', 4.1, "M 1 0 A 0.5 4.4 3.5 4 -55 0 O 2 4.85 2.05 2.15 0 360"},
    Drawn{'.', 0.2, "M 0.1 0 L 0.1 0.08"},
    Drawn{',', 0.5, "M 0.4 0.1 L 0 -1.2"},
    Drawn{':', 0.2, "M 0.1 0.3 L 0.1 0.38 M 0.1 4.2 L 0.1 4.28"},
    Drawn{'-', 2.8, "M 0 3 L 2.8 3"},
    Drawn{'+', 3.8, "M 0 3 L 3.8 3 M 1.9 1.1 L 1.9 4.9"},
    Drawn{'=', 3.6, "M 0 2.1 L 3.6 2.1 M 0 4.1 L 3.6 4.1"},
    Drawn{'/', 2.6, "M 0 -0.7 L 2.6 7.5"},
    Drawn{'(', 1.3, "O 4.2 3.2 4.2 5.6 130 230"},
    Drawn{')', 1.3, "O -2.9 3.2 4.2 5.6 50 -50"},
    Drawn{'%', 6.0, "O 1.2 5.5 1.2 1.5 0 360 M 4.9 7 L 1.1 0 O 4.8 1.5 1.2 1.5 0 360"},
    Drawn{'a', 3.6, "M 3.6 5 L 3.6 0 M 3.6 2.5 A 1.8 2.5 1.8 2.5 0 360"},
    Drawn{'b', 3.6, "M 0 7.4 L 0 0 M 0 2.5 A 1.8 2.5 1.8 2.5 180 540"},
    Drawn{'c', 3.3, "O 1.85 2.5 1.85 2.5 48 312"},
    Drawn{'d', 3.6, "M 3.6 7.4 L 3.6 0 M 3.6 2.5 A 1.8 2.5 1.8 2.5 0 360"},
    Drawn{'e', 3.7, "M 0.05 2.7 L 3.7 2.7 A 1.85 2.5 1.85 2.5 5 318"},
    Drawn{'f', 2.2, "M 0.8 0 L 0.8 5.9 A 2.2 5.9 1.4 1.5 180 95 M -0.2 5 L 2.1 5"},
    Drawn{'g', 3.6,
          "M 3.6 5 L 3.6 -0.3 A 1.8 -0.3 1.8 1.9 0 -150 M 3.6 2.5 A 1.8 2.5 1.8 2.5 0 360"},
    Drawn{'h', 3.3, "M 0 7.4 L 0 0 M 0 3.2 A 1.65 3.2 1.65 1.8 180 0 L 3.3 0"},
    Drawn{'i', 0.2, "M 0.1 5 L 0.1 0 M 0.1 6.9 L 0.1 7"},
    Drawn{'j', 0.8, "M 0.7 5 L 0.7 -0.6 A -0.7 -0.6 1.4 1.5 0 -85 M 0.7 6.9 L 0.7 7"},
    Drawn{'k', 3.2, "M 0 7.4 L 0 0 M 3 5 L 0 2 M 1.1 3.1 L 3.3 0"},
    Drawn{'l', 0.2, "M 0.1 7.4 L 0.1 0"},
    Drawn{'m', 5.6,
          "M 0 5 L 0 0 M 0 3.4 A 1.4 3.4 1.4 1.6 180 0 L 2.8 0 M 2.8 3.4 A 4.2 3.4 1.4 1.6 180 0 L "
          "5.6 0"},
    Drawn{'n', 3.3, "M 0 5 L 0 0 M 0 3.2 A 1.65 3.2 1.65 1.8 180 0 L 3.3 0"},
    Drawn{'o', 3.7, "O 1.85 2.5 1.85 2.5 0 360"},
    Drawn{'p', 3.6, "M 0 5 L 0 -2.2 M 0 2.5 A 1.8 2.5 1.8 2.5 180 540"},
    Drawn{'q', 3.6, "M 3.6 5 L 3.6 -2.2 M 3.6 2.5 A 1.8 2.5 1.8 2.5 0 360"},
    Drawn{'r', 2.0, "M 0 5 L 0 0 M 0 3 A 1.9 3 1.9 2 180 85"},
    Drawn{'s', 3.0, "O 1.5 3.72 1.38 1.28 40 270 A 1.5 1.22 1.5 1.22 90 -145"},
    Drawn{'t', 2.2, "M 0.8 6.6 L 0.8 1.4 A 2.2 1.4 1.4 1.4 180 265 M -0.2 5 L 2.1 5"},
    Drawn{'u', 3.3, "M 0 5 L 0 1.8 A 1.65 1.8 1.65 1.8 180 360 M 3.3 5 L 3.3 0"},
    Drawn{'v', 3.5, "M 0 5 L 1.75 0 L 3.5 5"},
    Drawn{'w', 5.2, "M 0 5 L 1.3 0 L 2.6 5 L 3.9 0 L 5.2 5"},
    Drawn{'x', 3.4, "M 0 5 L 3.4 0 M 3.4 5 L 0 0"},
    Drawn{'y', 3.5, "M 0 5 L 1.75 0 M 3.5 5 L 1 -2.2"},
    Drawn{'z', 3.2, "M 0.1 5 L 3.2 5 L 0 0 L 3.3 0"},
    Drawn{'D', 4.4, "M 0 0 L 0 7 L 1.4 7 A 1.4 3.5 3 3.5 90 -90 L 0 0"},
    Drawn{'Z', 4.3, "M 0.1 7 L 4.2 7 L 0 0 L 4.4 0"},
    Drawn{'\0', 3.5, "M 0 0 L 3.5 0 L 3.5 7 L 0 7 L 0 0"},
};

void add_arc(std::vector<Spot>& stroke, std::istream& numbers) {
    double cx = 0.0, cy = 0.0, rx = 0.0, ry = 0.0, from = 0.0, to = 0.0;
    numbers >> cx >> cy >> rx >> ry >> from >> to;
    const int pieces = 2 + static_cast<int>(std::abs(to - from) / 9.0);
    for (int k = 0; k <= pieces; ++k) {
        const double angle = (from + (to - from) * k / pieces) * std::numbers::pi / 180.0;
        stroke.push_back({cx + rx * std::cos(angle), cy + ry * std::sin(angle)});
    }
}

Letter letter_from(const Drawn& drawn) {
    Letter result{drawn.width, {}};
    std::istringstream commands(drawn.commands);
    for (char command = ' '; commands >> command;) {
        if (command == 'M' || command == 'O') result.strokes.emplace_back();
        if (command == 'A' || command == 'O') {
            add_arc(result.strokes.back(), commands);
        } else {
            Spot spot;
            commands >> spot.x >> spot.y;
            result.strokes.back().push_back(spot);
        }
    }
    return result;
}

std::array<Letter, 128> make_alphabet() {
    std::array<Letter, 128> alphabet;
    alphabet.fill(letter_from(drawn_letters.back()));
    for (const Drawn& drawn : drawn_letters)
        alphabet[static_cast<std::size_t>(drawn.character)] = letter_from(drawn);
    return alphabet;
}

}  // namespace

const Letter& letter(char character) {
    static const std::array<Letter, 128> alphabet = make_alphabet();
    const auto place = static_cast<unsigned char>(character);
    return alphabet[place < alphabet.size() ? place : 0];
}

}  // namespace jam
