// SPDX-License-Identifier: BSD-3-Clause
// jam_app run: from the scene to the files of a run.
#include "core/check.h"
#include "core/parallel.h"
#include "core/version.h"
#include "jam_app/commands.h"
#include "jam_app/progress.h"
#include "jam_app/record_file.h"
#include "jam_app/run_folder.h"
#include "jam_app/stop_signal.h"
#include "jamming/checkpoint_file.h"
#include "jamming/jam_packing.h"
#include "jamming/jammed_file.h"
#include "jamming/scene_file.h"
#include "shared/program.h"
#include "shared/shell_word.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jam::apps {

namespace {

/// One sitting of a run.
struct Sitting {
    const RunOptions& options;
    Scene scene;
    RunFolder folder;
    JamState state;
};

std::filesystem::path output_folder(const Scene& scene, const std::filesystem::path& scene_file) {
    return scene.run.output.empty() ? "runs" / scene_file.stem() : scene.run.output;
}

// --- beginning ----------------------------------------------------------------------------------

void require_same_run(const Scene& now, const std::string& scene_before,
                      const std::filesystem::path& folder) {
    const std::vector<std::string> changed =
        differences_of_runs(now, parse_scene(scene_before, folder));
    require(changed.empty(),
            "--resume: the run in {} is of another scene: {}; only [stop] and [run] may change, "
            "run.seed not; start a run of its own in another folder by --out",
            folder.string(), fmt::join(changed, ", "));
}

/// Nothing is written before the scene has given a state.
void begin_new(Sitting& sitting) {
    sitting.folder.require_free();
    sitting.state = start_state(sitting.scene);
    require_stable_time_step(sitting.scene, sitting.state);
    sitting.folder.occupy();
    save_checkpoint(sitting.state, scene_text(sitting.scene), sitting.folder.checkpoint());
}

void begin_again(Sitting& sitting) {
    sitting.folder.require_checkpoint();
    sitting.folder.occupy();
    Checkpoint checkpoint = load_checkpoint(sitting.folder.checkpoint());
    require_same_run(sitting.scene, checkpoint.scene, sitting.folder.path());
    sitting.state = std::move(checkpoint.state);
}

/// The last step whose record stays: a record made only because a sitting ended there goes, since
/// a run without interruption has none.
Count last_kept_record(const Sitting& sitting) {
    const Count step = sitting.state.step;
    return step % sitting.scene.run.record_interval == 0 ? step : step - 1;
}

// --- end -----------------------------------------------------------------------------------------

/// The command as it was given, but from the state in the folder, and beyond a limit on steps.
std::string how_to_go_on(const Sitting& sitting, JamOutcome outcome) {
    const SceneOptions& given = sitting.options.scene;
    std::string out =
        fmt::format("jam_app run {} --out {} --resume", shell_word(given.scene.string()),
                    shell_word(sitting.folder.path().string()));
    const bool at_limit = outcome == JamOutcome::step_limit;
    for (const std::string& one : given.overrides)
        if (!one.starts_with("run.output=") && !(at_limit && one.starts_with("stop.max_steps=")))
            out += fmt::format(" --set {}", shell_word(one));
    if (at_limit) out += fmt::format(" --set stop.max_steps={}", 2 * sitting.state.step);
    return out;
}

std::string ending(const StopSettings& stop, JamOutcome outcome, const StopSignal& signal) {
    switch (outcome) {
        case JamOutcome::converged:
            return "converged";
        case JamOutcome::step_limit:
            return fmt::format("not converged within stop.max_steps = {}", stop.max_steps);
        case JamOutcome::time_limit:
            return fmt::format("not converged within stop.max_time = {} s", stop.max_time);
        case JamOutcome::interrupted:
            break;
    }
    return fmt::format("stopped by {}", signal.name());
}

int tell_ending(const Sitting& sitting, const JamResult& result, const StopSignal& signal,
                Progress& progress) {
    progress.say(fmt::format("{}: at step {}, after {:.0f} s in all\n{}",
                             ending(sitting.scene.stop, result.outcome, signal), sitting.state.step,
                             sitting.state.wall_seconds, to_text(result.verdict)));
    const std::string packing = shell_word(sitting.folder.packing().string());
    progress.say(fmt::format("measure it: analyze_app stats {}", packing));
    if (result.outcome == JamOutcome::converged) return exit_good;
    progress.say(fmt::format("go on:      {}", how_to_go_on(sitting, result.outcome)));
    return exit_not_converged;
}

void note_times(const StageTimes& times, Progress& progress) {
    std::string line = "seconds by stage:";
    for (std::size_t stage = 0; stage < stage_count; ++stage)
        if (times.entered[stage] > 0)
            line += fmt::format(" {} {:.3g}", stage_names[stage], times.seconds[stage]);
    progress.note(line);
}

// --- middle -------------------------------------------------------------------------------------

JamResult jam(Sitting& sitting, const StopSignal& signal, Progress& progress) {
    const std::string text = scene_text(sitting.scene);
    RecordFile records(sitting.folder.record(), last_kept_record(sitting));
    JamHooks hooks;
    hooks.on_record = [&](const Record& record, const Verdict& verdict) {
        records.add(record);
        progress.show(record, verdict);
    };
    hooks.on_checkpoint = [&](const JamState& state) {
        save_checkpoint(state, text, sitting.folder.checkpoint());
    };
    hooks.stop_requested = [&] { return signal.came(); };
    return jam_packing(sitting.scene, sitting.state, hooks);
}

void save_result(JamResult& result, const Sitting& sitting) {
    Provenance& provenance = result.measurement.packing.provenance;
    provenance.creator = fmt::format("jam_app {}", version);
    provenance.command_line = sitting.options.command_line;
    provenance.scene = scene_text(sitting.scene);
    save_jammed(result, sitting.folder.packing());
}

int run_sitting(Sitting& sitting) {
    if (sitting.options.resume)
        begin_again(sitting);
    else
        begin_new(sitting);
    const StopSignal signal;
    Progress progress(sitting.scene, sitting.folder.log());
    progress.note(sitting.options.command_line);
    progress.say(fmt::format("{}: {} particles from step {}, results in {}",
                             sitting.options.scene.scene.string(), sitting.state.particles.size(),
                             sitting.state.step, sitting.folder.path().string()));
    std::optional<JamResult> at_once = ending_without_a_step(sitting.scene, sitting.state);
    JamResult result = at_once ? std::move(*at_once) : jam(sitting, signal, progress);
    save_result(result, sitting);
    note_times(result.times, progress);
    return tell_ending(sitting, result, signal, progress);
}

}  // namespace

int run_scene(const RunOptions& options) {
    const SceneOptions& given = options.scene;
    Scene scene = read_scene(given.scene, given.overrides);
    const std::filesystem::path folder = output_folder(scene, given.scene);
    const int threads = scene.run.threads;
    Sitting sitting{options, std::move(scene), RunFolder(folder), {}};
    return run_with_threads(threads, [&] { return run_sitting(sitting); });
}

}  // namespace jam::apps
