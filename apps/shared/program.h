// SPDX-License-Identifier: BSD-3-Clause
// What both programs share: exit statuses, and how errors reach the user.
#pragma once

#include <functional>

namespace jam::apps {

/// Exit statuses of the programs, part of their interface.
enum ExitStatus : int {
    exit_good = 0,           ///< done; for a run: converged
    exit_failed = 1,         ///< a file or the machine failed us, or a defect of ours
    exit_bad_input = 2,      ///< the user's input cannot be used; nothing was written
    exit_not_converged = 3,  ///< a limit or a signal stopped the run; its state is saved
};

/// Runs `program`; an exception becomes its message on standard error and the exit status that
/// belongs to it. Messages about input stand alone, so that each line begins with the place in the
/// file as compilers have it; others begin with the program's name.
int run_guarded(const char* program_name, const std::function<int()>& program);

}  // namespace jam::apps
