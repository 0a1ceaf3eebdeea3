// SPDX-License-Identifier: BSD-3-Clause
// The words with which bad input is refused.
#pragma once

#include "core/check.h"

#include <string>
#include <string_view>

namespace jam::test {

/// The message of the InputError or FileError that `action` throws; "" if it throws none.
template <typename Action>
std::string refusal_of(Action&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

/// `text` with the first `part` in it changed to `by`; throws if there is none.
std::string replaced(std::string text, std::string_view part, std::string_view by);

}  // namespace jam::test
