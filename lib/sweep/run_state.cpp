// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/run_state.h"

#include "core/check.h"
#include "core/whole_file.h"
#include "jamming/scene_file.h"

#include <algorithm>
#include <system_error>

namespace jam {

namespace fs = std::filesystem;

static constexpr std::string_view another_folder =
    "give another sweep.output (of a trade: another -o)";

static fs::path scene_file_of(const SweepRun& run) {
    return run.scene.run.output / "scene.toml";
}

/// Whether a packing that was converged by one scene is so by the other: nothing but [run] differs.
static bool same_criteria(const Scene& now, const Scene& before) {
    return std::ranges::all_of(scene_differences(now, before), [](const std::string& difference) {
        return difference.starts_with("run.");
    });
}

RunState state_of(const SweepRun& run) {
    const fs::path folder = run.scene.run.output;
    std::error_code none;
    if (!fs::exists(scene_file_of(run), none)) return RunState::left;
    const Scene before = read_scene(scene_file_of(run));
    const std::vector<std::string> changed = differences_of_runs(run.scene, before);
    require(changed.empty(),
            "{}: holds a run of another scene: {}; only [stop] and [run] of a sweep may change; "
            "{}, or remove the folder",
            folder.string(), fmt::join(changed, ", "), another_folder);
    if (fs::exists(folder / "converged", none) && same_criteria(run.scene, before))
        return RunState::converged;
    return fs::exists(folder / "checkpoint.h5", none) ? RunState::begun : RunState::left;
}

void prepare_folder(const SweepRun& run) {
    const fs::path folder = run.scene.run.output;
    make_folder(folder, another_folder);
    std::error_code none;
    fs::remove(folder / "converged", none);
    write_whole_file(scene_file_of(run), scene_text(run.scene));
}

void mark_converged(const SweepRun& run) {
    write_whole_file(run.scene.run.output / "converged", "by the criteria of scene.toml\n");
}

}  // namespace jam
