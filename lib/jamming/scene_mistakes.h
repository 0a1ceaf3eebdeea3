// SPDX-License-Identifier: BSD-3-Clause
// Collects what is wrong with a scene, so that the user hears all of it at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace jam {

class SceneMistakes {
  public:
    /// `where` is "file:line:column" or "--set"; `what` names key, value, rule and remedy.
    void add(std::string_view where, std::string_view what);

    /// Throws InputError with one line for each mistake, if there is any.
    void throw_if_any() const;

  private:
    std::vector<std::string> lines_;
};

/// The key that looks most like `name`, or empty if none does.
std::string nearest_scene_key(std::string_view name);

}  // namespace jam
