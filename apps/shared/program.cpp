// SPDX-License-Identifier: BSD-3-Clause
#include "shared/program.h"

#include "core/check.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

namespace jam::apps {

int run_guarded(const char* program_name, const std::function<int()>& program) {
    try {
        return program();
    } catch (const InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return exit_bad_input;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr,
                   "{}: this machine has not enough memory; "
                   "'jam_app check' says how much a scene needs\n",
                   program_name);
        return exit_failed;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", program_name, error.what());
        return exit_failed;
    }
}

}  // namespace jam::apps
