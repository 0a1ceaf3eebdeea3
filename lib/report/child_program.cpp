// SPDX-License-Identifier: BSD-3-Clause
#include "report/child_program.h"

#include "core/check.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace jam {

namespace {

/// A pipe whose ends close themselves.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            throw FileError(fmt::format("no pipe to another program ({})", std::strerror(errno)));
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void close_end(int which) {
        int& end = ends[static_cast<std::size_t>(which)];
        if (end >= 0) close(end);
        end = -1;
    }
};

/// What the child does before it becomes the program.
struct FileActions {
    posix_spawn_file_actions_t actions;

    FileActions(const Pipe& output, const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDERR_FILENO);
        posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;
};

std::string everything_from(int descriptor) {
    std::string text;
    std::array<char, 4096> piece;
    for (;;) {
        const ssize_t size = read(descriptor, piece.data(), piece.size());
        if (size > 0) text.append(piece.data(), static_cast<std::size_t>(size));
        if (size == 0 || (size < 0 && errno != EINTR)) return text;
    }
}

int exit_status_of(pid_t child) {
    int state = 0;
    while (waitpid(child, &state, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

}  // namespace

ChildRun run_child(const std::vector<std::string>& command, const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    Pipe output;
    const FileActions before(output, folder);
    pid_t child = 0;
    const int problem =
        posix_spawnp(&child, arguments[0], &before.actions, nullptr, arguments.data(), environ);
    if (problem == ENOENT) return {false, -1, ""};
    if (problem != 0)
        throw FileError(
            fmt::format("{}: cannot be started ({})", command[0], std::strerror(problem)));
    output.close_end(1);
    ChildRun run;
    run.words = everything_from(output.ends[0]);
    run.status = exit_status_of(child);
    return run;
}

}  // namespace jam
