// SPDX-License-Identifier: BSD-3-Clause
#include "support/refusals.h"

#include <stdexcept>

namespace jam::test {

std::string replaced(std::string text, std::string_view part, std::string_view by) {
    const std::size_t at = text.find(part);
    if (at == std::string::npos) throw std::logic_error("not in the text: " + std::string(part));
    return text.replace(at, part.size(), by);
}

}  // namespace jam::test
