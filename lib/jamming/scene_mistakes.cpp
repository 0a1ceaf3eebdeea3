// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene_mistakes.h"

#include "core/check.h"
#include "jamming/scene_keys.h"

#include <algorithm>
#include <numeric>

namespace jam {

void SceneMistakes::add(std::string_view where, std::string_view what) {
    lines_.push_back(fmt::format("{}: {}", where, what));
}

void SceneMistakes::throw_if_any() const {
    if (!lines_.empty()) throw InputError(fmt::format("{}", fmt::join(lines_, "\n")));
}

/// Fewest insertions, deletions and exchanges of one character that turn `a` into `b`
/// (Levenshtein).
static std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

static std::string_view last_part(std::string_view name) {
    return name.substr(name.rfind('.') + 1);  // npos + 1 is 0: all of it
}

std::string nearest_scene_key(std::string_view name) {
    std::string nearest;
    std::size_t least = std::max<std::size_t>(2, name.size() / 4) + 1;
    for (const SceneKey& key : scene_keys()) {
        // A key may also stand in the wrong table, or in none.
        const std::size_t misplaced = last_part(key.name) == last_part(name) ? 1 : least;
        const std::size_t distance = std::min(edit_distance(name, key.name), misplaced);
        if (distance < least) {
            least = distance;
            nearest = key.name;
        }
    }
    return nearest;
}

}  // namespace jam
