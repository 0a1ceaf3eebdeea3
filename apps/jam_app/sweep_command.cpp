// SPDX-License-Identifier: BSD-3-Clause
// jam_app sweep: many runs, as many at once as the machine bears, or one of them.
#include "core/check.h"
#include "core/whole_file.h"
#include "jam_app/child_runs.h"
#include "jam_app/commands.h"
#include "jam_app/stop_signal.h"
#include "jam_app/sweep_table.h"
#include "jam_app/swept_run.h"
#include "shared/program.h"
#include "shared/shell_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <thread>

namespace jam::apps {

namespace {

// --- one run ------------------------------------------------------------------------------------

const SweepRun& run_named(const Sweep& sweep, const SweepOptions& options) {
    const auto at = std::ranges::find(sweep.runs, options.only, &SweepRun::name);
    require(at != sweep.runs.end(),
            "--only: {}: must be the name of a run of {}; jam_app sweep {} --list has them all",
            options.only, options.file.string(), options.file.string());
    return *at;
}

int run_one(const Sweep& sweep, const SweepOptions& options) {
    const SweepRun& run = run_named(sweep, options);
    const RunState state = state_of(run);
    if (state == RunState::converged) {
        fmt::print("{}: has converged already\n", run.name);
        return exit_good;
    }
    return do_swept_run(run, state, options.command_line, options.threads);
}

std::vector<std::string> command_of(const SweepRun& run, const SweepOptions& options) {
    return {"jam_app", "sweep", options.file.string(), "--only", run.name};
}

int list_runs(const Sweep& sweep, const SweepOptions& options) {
    for (const SweepRun& run : sweep.runs) {
        std::vector<std::string> words = command_of(run, options);
        std::ranges::transform(words, words.begin(), shell_word);
        fmt::print("{}\n", fmt::join(words, " "));
    }
    return exit_good;
}

// --- all runs -----------------------------------------------------------------------------------

/// What the runs share.
struct Machine {
    int threads;
    double memory;  ///< bytes
};

/// Bytes that are free for us now, as the system reckons; without limit where it does not say.
double available_memory() {
    std::ifstream in("/proc/meminfo");
    std::string name;
    double kilobytes = 0.0;
    while (in >> name)
        if (name == "MemAvailable:" && in >> kilobytes) return 1024.0 * kilobytes;
    return 1e300;
}

Machine machine_of(const Sweep& sweep) {
    constexpr double left_to_others = 0.1;
    const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return {sweep.threads > 0 ? sweep.threads : all,
            sweep.memory > 0.0 ? 1e9 * sweep.memory : (1.0 - left_to_others) * available_memory()};
}

/// Threads for each run, so that no thread is idle while there are runs.
int threads_a_run(const Sweep& sweep, const Machine& machine, Count unfinished) {
    if (sweep.threads_a_run > 0) return std::min(sweep.threads_a_run, machine.threads);
    return std::max(1, machine.threads / static_cast<int>(std::max<Count>(1, unfinished)));
}

/// The end of a run that the sweep stopped before it could heed the signal: nothing was to be
/// saved.
constexpr int stopped_unbegun = -SIGTERM;

class SweepSitting {
  public:
    SweepSitting(const Sweep& sweep, const SweepOptions& options)
        : sweep_(sweep), options_(options), table_(sweep), machine_(machine_of(sweep)) {
        for (const SweepRun& run : sweep.runs)
            statuses_.push_back(state_of(run) == RunState::converged ? RunStatus::converged
                                                                     : RunStatus::left);
        threads_ = threads_a_run(sweep, machine_, std::ranges::count(statuses_, RunStatus::left));
    }

    int run() {
        table_.say(
            fmt::format("{}: {} runs, {} of them done, results in {}; {} thread(s) a run, {} in "
                        "all, {:.1f} GB",
                        options_.file.string(), statuses_.size(),
                        std::ranges::count(statuses_, RunStatus::converged), sweep_.output.string(),
                        threads_, machine_.threads, machine_.memory / 1e9));
        const StopSignal signal;
        bool stopping = false;
        for (;;) {
            for (const EndedRun& ended : children_.take_ended()) note_end(ended);
            if (signal.came() && !stopping) {
                stopping = true;
                table_.say(fmt::format("{}: the runs save their states", signal.name()));
                children_.stop();
            }
            if (!stopping) start_what_fits();
            if (children_.running().empty()) break;
            table_.show(statuses_);
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        table_.close(statuses_);
        return status();
    }

  private:
    void start_what_fits() {
        for (std::size_t i = 0; i < statuses_.size(); ++i) {
            if (statuses_[i] != RunStatus::left) continue;
            int threads = threads_;
            double memory = memory_of(i);
            for (const ChildRun& child : children_.running()) {
                threads += child.threads;
                memory += child.memory;
            }
            if (threads > machine_.threads) return;
            // A run that fits nowhere is tried alone: the estimate may be too high.
            if (memory > machine_.memory && !children_.running().empty()) continue;
            start(i);
        }
    }

    void start(std::size_t i) {
        const SweepRun& run = sweep_.runs[i];
        make_folder(run.scene.run.output, "set another sweep.output");
        std::vector<std::string> command = command_of(run, options_);
        command.insert(command.end(), {"--threads", std::to_string(threads_)});
        children_.start({-1, i, threads_, memory_of(i)}, command, output_file(run));
        statuses_[i] = RunStatus::running;
        table_.say(fmt::format("started    {}", run.name));
    }

    void note_end(const EndedRun& ended) {
        const char* what = "failed";
        statuses_[ended.run] = RunStatus::failed;
        if (ended.status == exit_good) {
            what = "converged";
            statuses_[ended.run] = RunStatus::converged;
        } else if (ended.status == exit_not_converged || ended.status == stopped_unbegun) {
            what = "stopped";
            statuses_[ended.run] = RunStatus::stopped;
        }
        table_.say(fmt::format("{:<11}{}", what, sweep_.runs[ended.run].name));
    }

    double memory_of(std::size_t i) {
        memory_.resize(statuses_.size());
        if (!memory_[i]) memory_[i] = memory_of_run(sweep_.runs[i].scene);
        return *memory_[i];
    }

    int status() const {
        if (std::ranges::count(statuses_, RunStatus::failed) > 0) return exit_failed;
        const auto converged = std::ranges::count(statuses_, RunStatus::converged);
        return converged == std::ssize(statuses_) ? exit_good : exit_not_converged;
    }

    const Sweep& sweep_;
    const SweepOptions& options_;
    SweepTable table_;
    Machine machine_;
    int threads_ = 1;
    std::vector<RunStatus> statuses_;
    std::vector<std::optional<double>> memory_;
    ChildRuns children_;
};

}  // namespace

int sweep_scenes(const SweepOptions& options) {
    const Sweep sweep = read_sweep(options.file);
    if (options.list) return list_runs(sweep, options);
    if (!options.only.empty()) return run_one(sweep, options);
    return SweepSitting(sweep, options).run();
}

}  // namespace jam::apps
