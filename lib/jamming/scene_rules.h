// SPDX-License-Identifier: BSD-3-Clause
// What a key of a scene may hold. Each rule states itself (`text`), takes a value that keeps it
// (`read`) and gives it back (`write`), so that check, message and documentation cannot differ.
#pragma once

#include "core/types.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace jam {

/// The value of a key as it stands in a file; monostate for what no key takes (a date, a table).
using SceneValue =
    std::variant<std::monostate, bool, Count, double, std::string, std::vector<double>>;

/// The shortest text that reads back to the same bits, as people write it: 1e-6, not 1e-06.
std::string number_text(double number);

/// A finite number within an interval.
struct Real {
    double least;
    double most = 1e12;  ///< beyond any use, and far from where a square overflows
    bool least_included = true;
    bool most_included = true;

    std::string text() const;
    std::optional<double> read(const SceneValue& value) const;
    std::optional<SceneValue> write(double number) const { return number; }
};

inline Real above(double bound, double most = 1e12) {
    return {bound, most, false};
}
inline Real between(double least, double most) {
    return {least, most, false, false};
}
inline Real from(double least, double most = 1e12) {
    return {least, most, true};
}

struct YesNo {
    std::string text() const { return "true or false"; }
    std::optional<bool> read(const SceneValue& value) const;
    std::optional<SceneValue> write(bool truth) const { return truth; }
};

/// A whole number within an interval; 1e6 is one, too.
struct Whole {
    Count least;
    Count most = std::numeric_limits<Count>::max();

    std::string text() const;
    std::optional<Count> read(const SceneValue& value) const;
    std::optional<SceneValue> write(Count number) const { return number; }
};

/// One of a few words, each with its meaning to the program.
template <typename Meaning>
struct Choice {
    std::vector<std::pair<std::string, Meaning>> words;

    std::string text() const {
        std::string out = "one of";
        for (const auto& [word, meaning] : words)
            out += (out.size() > 6 ? ", " : " ") + quoted(word);
        return out;
    }
    std::optional<Meaning> read(const SceneValue& value) const {
        const auto* given = std::get_if<std::string>(&value);
        for (const auto& [word, meaning] : words)
            if (given && *given == word) return meaning;
        return std::nullopt;
    }
    std::optional<SceneValue> write(Meaning wanted) const {
        for (const auto& [word, meaning] : words)
            if (meaning == wanted) return word;
        return std::nullopt;
    }

  private:
    static std::string quoted(const std::string& word) { return '"' + word + '"'; }
};

/// The path of a file or folder; not written while empty.
struct PathText {
    std::string text() const { return "a path in quotes"; }
    std::optional<std::filesystem::path> read(const SceneValue& value) const;
    std::optional<SceneValue> write(const std::filesystem::path& path) const;
};

/// A number, or the word "automatic" for nothing.
struct RealOrAutomatic {
    Real number;

    std::string text() const { return number.text() + ", or \"automatic\""; }
    std::optional<std::optional<double>> read(const SceneValue& value) const;
    std::optional<SceneValue> write(const std::optional<double>& chosen) const;
};

/// A symmetric tensor with positive principal values: one number (isotropic) or six.
struct PressureTensor {
    double most = 1e12;

    std::string text() const;
    std::optional<Mat3> read(const SceneValue& value) const;
    std::optional<SceneValue> write(const Mat3& pressure) const;
};

}  // namespace jam
