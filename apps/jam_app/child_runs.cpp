// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/child_runs.h"

#include "core/check.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace jam::apps {

static constexpr int exit_not_started = 127;

/// The rest of a new process' life as ours; only calls that are safe after fork.
[[noreturn]] static void become(char* const* arguments, int output) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    setpgid(0, 0);  // Ctrl-C on the terminal is for the sweep, which passes it on once
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    execv("/proc/self/exe", arguments);
    _exit(exit_not_started);
}

void ChildRuns::start(ChildRun child, const std::vector<std::string>& arguments,
                      const std::filesystem::path& output) {
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file < 0)
        throw FileError(fmt::format("{}: cannot be written ({}); see to the rights of the folder",
                                    output.string(), std::strerror(errno)));
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));  // NOLINT: execv changes none of them
    words.push_back(nullptr);
    child.process = fork();
    if (child.process == 0) become(words.data(), file);
    close(file);
    if (child.process < 0)
        throw FileError(
            fmt::format("a run cannot be started ({}); lower sweep.threads", std::strerror(errno)));
    running_.push_back(child);
}

std::vector<EndedRun> ChildRuns::take_ended() {
    std::vector<EndedRun> ended;
    std::erase_if(running_, [&](const ChildRun& child) {
        int status = 0;
        if (waitpid(child.process, &status, WNOHANG) != child.process) return false;
        ended.push_back({child.run, WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status)});
        return true;
    });
    return ended;
}

void ChildRuns::stop() const {
    for (const ChildRun& child : running_) kill(child.process, SIGTERM);
}

}  // namespace jam::apps
