// SPDX-License-Identifier: BSD-3-Clause
// jam_app trade: what a scene's speed costs in accuracy, measured.
#include "core/whole_file.h"
#include "jam_app/commands.h"
#include "jam_app/swept_run.h"
#include "jamming/checkpoint_file.h"
#include "jamming/scene_file.h"
#include "shared/drawing_words.h"
#include "shared/program.h"
#include "sweep/trade.h"
#include "sweep/trade_figure.h"

#include <fmt/format.h>

#include <algorithm>

namespace jam::apps {

namespace {

bool at_limit(const SweepRun& run) {
    return load_checkpoint(run.scene.run.output / "checkpoint.h5").state.step >=
           run.scene.stop.max_steps;
}

/// Takes the run to its end: converged, or at its limit on steps. False if it was stopped before.
bool finish(const SweepRun& run, const std::string& headline, const std::string& command_line) {
    const RunState state = state_of(run);
    if (state == RunState::converged || (state == RunState::begun && at_limit(run))) return true;
    fmt::print("{}", headline);
    return do_swept_run(run, state, command_line) == exit_good || at_limit(run);
}

void print_table(std::span<const TradePoint> points) {
    fmt::print("\n{:<32}{:>10}{:>12}{:>11}{:>11}{:>11}{:>11}  {}\n", "choice", "wall s",
               "evaluations", "phi", "phi_nr", "Z_nr", "f_r", "front");
    for (const TradePoint& point : points)
        fmt::print(
            "{:<32}{:>10.3g}{:>12.6g}{:>11.2g}{:>11.2g}{:>11.2g}{:>11.2g}  {}{}{}\n", point.name,
            point.wall_seconds.mean, point.evaluations.mean, point.volume_fraction.mean,
            point.volume_fraction_nr.mean, point.coordination_nr.mean, point.rattler_fraction.mean,
            point.front_of_volume_fraction ? "phi " : "", point.front_of_coordination ? "Z_nr" : "",
            point.converged == point.seeds ? "" : " (not converged)");
}

void write_results(std::span<const TradePoint> points, const std::filesystem::path& folder) {
    write_whole_file(folder / "trade.csv", trade_csv(points));
    const Figure figure = trade_figure(points);
    write_figures({&figure, 1}, folder);
    tell_of_drawing(draw_figures({&figure, 1}, folder));
}

}  // namespace

int trade_scene(const TradeOptions& options) {
    const Scene scene = read_scene(options.scene.scene, options.scene.overrides);
    const std::vector<TradeChoice> choices = trade_choices(scene);
    const std::vector<SweepRun> runs = trade_runs(options.scene.scene, options.scene.overrides,
                                                  choices, options.seeds, options.folder);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::string headline =
            fmt::format("\nrun {} of {}: {}\n", i + 1, runs.size(), runs[i].name);
        if (!finish(runs[i], headline, options.command_line)) return exit_not_converged;
    }
    std::vector<TradeResult> results(runs.size());
    std::ranges::transform(runs, results.begin(), read_trade_result);
    const std::vector<TradePoint> points = trade_points(choices, results);
    write_results(points, options.folder);
    print_table(points);
    fmt::print("\nerrors are against {}, seed by seed; table and figure: {}\n",
               choices.front().name, (options.folder / "trade.csv").string());
    return exit_good;
}

}  // namespace jam::apps
