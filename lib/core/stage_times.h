// SPDX-License-Identifier: BSD-3-Clause
// Wall time by stage, kept as data by whoever runs the stages.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace jam {

/// The stages of a run, in the order in which a step meets them.
enum class Stage : std::uint8_t {
    place,
    sort,
    search,
    refilter,
    forces,
    integrate,
    metric,
    newton,
    measure,
    save
};
inline constexpr std::size_t stage_count = 10;
inline constexpr std::array<std::string_view, stage_count> stage_names = {
    "place",     "sort",   "search", "refilter", "forces",
    "integrate", "metric", "newton", "measure",  "save"};

/// Seconds spent and times entered, by stage.
struct StageTimes {
    std::array<double, stage_count> seconds{};
    std::array<std::int64_t, stage_count> entered{};

    StageTimes& operator+=(const StageTimes& other) {
        for (std::size_t stage = 0; stage < stage_count; ++stage) {
            seconds[stage] += other.seconds[stage];
            entered[stage] += other.entered[stage];
        }
        return *this;
    }
};

/// Adds the life of this object to one stage.
class StageTimer {
  public:
    StageTimer(StageTimes& times, Stage stage)
        : times_(times), stage_(static_cast<std::size_t>(stage)) {}
    ~StageTimer() {
        times_.seconds[stage_] +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        ++times_.entered[stage_];
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    StageTimes& times_;
    std::size_t stage_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace jam
