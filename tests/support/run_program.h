// SPDX-License-Identifier: BSD-3-Clause
// Runs one of our programs as a user does.
#pragma once

#include <string>
#include <vector>

namespace jam::test {

struct ProgramRun {
    int status = -1;  ///< exit status; -1 if a signal ended it
    std::string out;
    std::string err;
};

/// Runs `program` with `arguments`, each passed as it is, and waits for its end.
ProgramRun run_program(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace jam::test
