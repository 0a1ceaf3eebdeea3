// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/progress.h"

#include "jam_app/terminal.h"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

namespace jam::apps {

static std::shared_ptr<spdlog::logger> make_log(const std::filesystem::path& file,
                                                bool on_terminal) {
    std::vector<spdlog::sink_ptr> sinks = {
        std::make_shared<spdlog::sinks::basic_file_sink_mt>(file.string())};
    if (!on_terminal) sinks.push_back(std::make_shared<spdlog::sinks::stdout_sink_mt>());
    auto log = std::make_shared<spdlog::logger>("jam_app", sinks.begin(), sinks.end());
    log->set_pattern("%Y-%m-%d %H:%M:%S  %v");
    log->flush_on(spdlog::level::info);
    return log;
}

Progress::Progress(const Scene& scene, const std::filesystem::path& log_file)
    : applied_pressure_(scene.protocol.pressure.trace() / 3.0),
      stop_(scene.stop),
      on_terminal_(on_terminal()),
      log_(make_log(log_file, on_terminal_)) {}

Progress::~Progress() {
    clear_live_line();
}

static std::string duration(double seconds) {
    if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
    if (seconds < 100.0 * 60.0) return fmt::format("{:.0f} min", seconds / 60.0);
    if (seconds < 100.0 * 3600.0) return fmt::format("{:.1f} h", seconds / 3600.0);
    return fmt::format("{:.0f} days", seconds / 86400.0);
}

/// When a run converges cannot be known; by when a limit will have stopped it can.
static std::string time_left(const Record& record, const StopSettings& stop, double sitting) {
    double seconds = static_cast<double>(stop.max_steps - record.step) / record.steps_per_second;
    if (stop.max_time > 0.0) seconds = std::fmin(seconds, stop.max_time - sitting);
    return std::isfinite(seconds) ? "at most " + duration(std::max(0.0, seconds)) + " left" : "";
}

static std::string speed(const Record& record) {
    return std::isfinite(record.steps_per_second)
               ? fmt::format("{:.4g} steps/s", record.steps_per_second)
               : "";
}

/// The last one that is missing by its name and value: it is what a run waits for.
static std::string criteria(const Verdict& verdict) {
    const std::vector<Criterion>& all = verdict.criteria;
    const auto held = static_cast<std::size_t>(std::ranges::count_if(all, &Criterion::holds));
    std::string text = fmt::format("{} of {} criteria", held, all.size());
    const auto missing = std::ranges::find_if_not(all, &Criterion::holds);
    if (held + 1 == all.size() && !std::isnan(missing->value))
        text += fmt::format(", {} {:.1e}", missing->name, missing->value);
    return text;
}

/// The most telling first: the last ones go where the line is short.
static std::vector<std::string> fields(const Record& record, const Verdict& verdict,
                                       double applied_pressure, const std::string& left) {
    return {
        fmt::format("step {}", record.step),
        fmt::format("phi {:.5f}", record.volume_fraction),
        fmt::format("Z_nr {:.3f}", record.coordination_nr),
        fmt::format("P/Pa {:.4g}", record.pressure.trace() / 3.0 / applied_pressure),
        std::isnan(record.cundall) ? "C -" : fmt::format("C {:.1e}", record.cundall),
        fmt::format("Ek {:.1e}", record.kinetic_energy_per_particle),
        criteria(verdict),
        speed(record),
        left,
        fmt::format("Z {:.3f}", record.coordination),
        fmt::format("t {:.4g}", record.time),
    };
}

/// As many whole fields as fit.
static std::string joined(const std::vector<std::string>& parts, std::size_t width) {
    std::string line;
    for (const std::string& part : parts) {
        const std::string next = part.empty() || line.empty() ? part : "  " + part;
        if (line.size() + next.size() > width) break;
        line += next;
    }
    return line;
}

void Progress::show(const Record& record, const Verdict& verdict) {
    const Clock::time_point now = Clock::now();
    const double sitting = std::chrono::duration<double>(now - began_).count();
    const std::vector<std::string> parts =
        fields(record, verdict, applied_pressure_, time_left(record, stop_, sitting));
    if (on_terminal_) {
        fmt::print("\r\x1b[K{}",
                   joined(parts, static_cast<std::size_t>(terminal_size().columns) - 1));
        std::fflush(stdout);
        live_line_shown_ = true;
    }
    if (now < next_line_) return;
    next_line_ = now + std::chrono::seconds(30);
    constexpr std::size_t any_width = 1000;
    log_->info(joined(parts, any_width));
}

void Progress::say(const std::string& text) {
    clear_live_line();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (on_terminal_) fmt::print("{}\n", line);
        log_->info(line);
    }
    std::fflush(stdout);
}

void Progress::note(const std::string& text) {
    log_->info(text);
}

void Progress::clear_live_line() {
    if (live_line_shown_) fmt::print("\r\x1b[K");
    std::fflush(stdout);
    live_line_shown_ = false;
}

}  // namespace jam::apps
