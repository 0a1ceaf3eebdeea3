// SPDX-License-Identifier: BSD-3-Clause
// How the library says no: one exception for the user's mistakes, and a check that states its rule.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace jam {

/// Something the user gave (a scene, a file, an argument) cannot be used. `what()` names the key or
/// file, its value, the rule and the remedy, in that order, ready to be shown.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file or the disk failed us (cannot be opened, full, damaged). `what()` names the path, the
/// reason and the remedy.
class FileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws InputError with the formatted message unless `rule_holds`.
template <typename... Args>
void require(bool rule_holds, fmt::format_string<Args...> message, Args&&... args) {
    if (!rule_holds) throw InputError(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace jam
