// SPDX-License-Identifier: BSD-3-Clause
#include "support/run_program.h"

#include "support/scratch_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <sys/wait.h>

namespace jam::test {

namespace {

std::string quoted(const std::string& word) {
    std::string result(1, '\'');
    for (const char letter : word) {
        if (letter == '\'')
            result.append("'\\''");
        else
            result.push_back(letter);
    }
    result.push_back('\'');
    return result;
}

}  // namespace

ProgramRun run_program(const std::string& program, const std::vector<std::string>& arguments) {
    const ScratchFolder scratch;
    std::string command = quoted(program);
    for (const std::string& argument : arguments) command += fmt::format(" {}", quoted(argument));
    command += fmt::format(" >{} 2>{}", quoted(scratch / "out"), quoted(scratch / "err"));
    const int ended = std::system(command.c_str());
    ProgramRun run;
    if (WIFEXITED(ended)) run.status = WEXITSTATUS(ended);
    run.out = content_of(scratch / "out");
    run.err = content_of(scratch / "err");
    return run;
}

}  // namespace jam::test
