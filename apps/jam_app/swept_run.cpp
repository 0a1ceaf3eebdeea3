// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/swept_run.h"

#include "jam_app/commands.h"
#include "jamming/scene_keys.h"
#include "shared/program.h"

#include <fmt/format.h>

namespace jam::apps {

int do_swept_run(const SweepRun& run, RunState state, const std::string& command_line,
                 std::optional<int> threads) {
    prepare_folder(run);
    RunOptions one;
    one.scene.scene = run.scene.run.output / "scene.toml";
    one.scene.overrides = {"run.output=" + toml_text(run.scene.run.output.string())};
    if (threads) one.scene.overrides.push_back(fmt::format("run.threads={}", *threads));
    one.resume = state == RunState::begun;
    one.command_line = command_line;
    const int status = run_scene(one);
    if (status == exit_good) mark_converged(run);
    return status;
}

}  // namespace jam::apps
