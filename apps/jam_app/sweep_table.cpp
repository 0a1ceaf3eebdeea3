// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/sweep_table.h"

#include "jam_app/terminal.h"
#include "jamming/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>

namespace jam::apps {

namespace fs = std::filesystem;

static constexpr std::array<std::pair<RunStatus, const char*>, 5> names = {
    {{RunStatus::converged, "converged"},
     {RunStatus::running, "running"},
     {RunStatus::stopped, "stopped"},
     {RunStatus::failed, "failed"},
     {RunStatus::left, "left"}}};

fs::path output_file(const SweepRun& run) {
    return run.scene.run.output / "output.log";
}

static std::string counts(const std::vector<RunStatus>& statuses) {
    std::string out = fmt::format("{} runs:", statuses.size());
    for (const auto& [status, name] : names)
        out += fmt::format(" {} {}{}", std::ranges::count(statuses, status), name,
                           status == RunStatus::left ? "" : ",");
    return out;
}

/// The last whole line of a file that may be long and may be growing; empty if there is none.
static std::string last_line(const fs::path& file) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = in ? std::streamoff(in.tellg()) : 0;
    constexpr std::streamoff longest = 8192;
    std::string text(static_cast<std::size_t>(std::min(size, longest)), '\0');
    in.seekg(size - std::ssize(text));
    in.read(text.data(), std::ssize(text));
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n'));
    return text.substr(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
}

static std::string progress(const SweepRun& run) {
    const std::string line = last_line(run.scene.run.output / "record.jsonl");
    if (line.empty()) return "no record yet";
    try {
        const Record record = record_from_json(line);
        const double applied = run.scene.protocol.pressure.trace() / 3.0;
        return fmt::format("step {:<9} phi {:.5f}  Z_nr {:.3f}  P/Pa {:.4g}  C {:.1e}", record.step,
                           record.volume_fraction, record.coordination_nr,
                           record.pressure.trace() / 3.0 / applied, record.cundall);
    } catch (const std::exception&) {  // a line cut off where the file's end was read
        return "";
    }
}

SweepTable::SweepTable(const Sweep& sweep) : sweep_(sweep), on_terminal_(on_terminal()) {}

void SweepTable::clear() {
    if (lines_shown_ > 0) fmt::print("\x1b[{}A\x1b[J", lines_shown_);
    lines_shown_ = 0;
}

void SweepTable::show(const std::vector<RunStatus>& statuses) {
    if (!on_terminal_) return;
    const TerminalSize size = terminal_size();
    std::size_t width = 0;
    for (const SweepRun& run : sweep_.runs) width = std::max(width, run.name.size());
    std::vector<std::string> lines = {counts(statuses)};
    for (std::size_t i = 0; i < statuses.size(); ++i)
        if (statuses[i] == RunStatus::running && std::ssize(lines) < size.rows - 2)
            lines.push_back(
                fmt::format("  {:<{}}  {}", sweep_.runs[i].name, width, progress(sweep_.runs[i])));
    clear();
    for (const std::string& line : lines)
        fmt::print("{}\n", line.substr(0, static_cast<std::size_t>(size.columns) - 1));
    std::fflush(stdout);
    lines_shown_ = static_cast<int>(lines.size());
}

void SweepTable::say(std::string_view text) {
    clear();
    fmt::print("{}\n", text);
    std::fflush(stdout);
}

void SweepTable::close(const std::vector<RunStatus>& statuses) {
    clear();
    for (std::size_t i = 0; i < statuses.size(); ++i)
        if (statuses[i] == RunStatus::failed)
            fmt::print("failed: {}: {} ({})\n", sweep_.runs[i].name,
                       last_line(output_file(sweep_.runs[i])),
                       output_file(sweep_.runs[i]).string());
    fmt::print("{}\n", counts(statuses));
}

}  // namespace jam::apps
