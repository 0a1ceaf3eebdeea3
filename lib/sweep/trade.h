// SPDX-License-Identifier: BSD-3-Clause
// The trade of speed for accuracy: one scene over the choices that make it quicker or better, each
// changed alone, and what each costs and loses.
#pragma once

#include "analysis/packing_statistics.h"
#include "sweep/sweep_file.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace jam {

/// One way to run a scene.
struct TradeChoice {
    std::string name;                    ///< such as "descent_rate=1e-3": of folders, too
    std::vector<std::string> overrides;  ///< "table.key=value"
};

/// The choices for a scene: accuracy, descent, compaction, tolerance of convergence, pressure, and
/// inertia (protocol nph) with its masses and time step. The first, protocol.accuracy = "paper", is
/// what the others are measured against.
std::vector<TradeChoice> trade_choices(const Scene& scene);

/// Every choice for every seed, seed by seed; run.seed counts up from the scene's. Their folders
/// lie in `output`. A key that the scene file gives is overruled by a choice's, not by the defaults
/// of its accuracy. Throws InputError as read_scene.
std::vector<SweepRun> trade_runs(const std::filesystem::path& scene_file,
                                 const std::vector<std::string>& overrides,
                                 std::span<const TradeChoice> choices, int seeds,
                                 const std::filesystem::path& output);

/// What one run came to.
struct TradeResult {
    PackingStatistics statistics;
    double pressure_error = 0.0;  ///< of the six components, over the mean of the run's own
    double wall_seconds = 0.0;
    double evaluations = 0.0;  ///< of the forces, a factorization counted as one
    bool converged = false;    ///< by the run's own criteria
};

/// Reads it from the run's folder. Throws FileError.
TradeResult read_trade_result(const SweepRun& run);

/// A mean over seeds, with its standard error; the latter is not a number for one seed.
struct MeanOverSeeds {
    double mean = 0.0;
    double error = 0.0;
};

/// One choice over its seeds. The errors are absolute differences from the first choice, seed by
/// seed.
struct TradePoint {
    std::string name;
    int seeds = 0;
    int converged = 0;  ///< seeds
    MeanOverSeeds wall_seconds, evaluations;
    MeanOverSeeds volume_fraction, volume_fraction_nr, coordination_nr, rattler_fraction;
    double pressure_error = 0.0;
    bool front_of_volume_fraction = false;  ///< no other point is both quicker and nearer
    bool front_of_coordination = false;
};

/// `results` in the order of trade_runs.
std::vector<TradePoint> trade_points(std::span<const TradeChoice> choices,
                                     std::span<const TradeResult> results);

/// One row a point.
std::string trade_csv(std::span<const TradePoint> points);

}  // namespace jam
