// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/trade.h"

#include "core/check.h"
#include "jamming/checkpoint_file.h"
#include "jamming/convergence.h"
#include "jamming/nph_step.h"
#include "jamming/quasistatic.h"
#include "jamming/scene_file.h"
#include "jamming/scene_keys.h"
#include "packing/packing_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

// --- choices ------------------------------------------------------------------------------------

namespace {

/// Steps that inertia is given; what has not converged by then has not.
constexpr const char* limit_of_inertia = "stop.max_steps=300000";

TradeChoice one_key(const std::string& key, const std::string& value) {
    return {fmt::format("{}={}", key.substr(key.find('.') + 1), value),
            {fmt::format("{}={}", key, value)}};
}

std::string pressure_text(const Mat3& pressure) {
    return toml_text(*PressureTensor{}.write(pressure));
}

void add_tolerances(std::vector<TradeChoice>& choices) {
    for (const char* cundall : {"1e-2", "1e-3", "1e-4"}) {
        TradeChoice loose = one_key("stop.cundall", cundall);
        loose.overrides.insert(loose.overrides.end(),
                               {"stop.stability=false", "stop.pressure=1e-2"});
        choices.push_back(std::move(loose));
    }
}

void add_compactions(const Scene& scene, const JamState& start, std::vector<TradeChoice>& choices) {
    const double pressure =
        automatic_compaction_pressure(scene.contact, diameters_by_id(start.particles));
    for (const double factor : {0.1, 0.3, 3.0}) {
        TradeChoice choice =
            one_key("protocol.compaction_pressure", number_text(factor * pressure));
        choice.name = fmt::format("compaction_pressure*{}", factor);
        choices.push_back(std::move(choice));
    }
    choices.push_back(one_key("protocol.compaction_steps", "1000"));
    choices.push_back(one_key("protocol.compaction_steps", "20000"));
}

/// Overlaps beyond some thousandths of a diameter are another material, not a quicker run.
void add_pressures(const Scene& scene, std::vector<TradeChoice>& choices) {
    for (const double factor : {1e3, 1e2, 1e1, 1e-1}) {
        const Mat3 pressure = factor * scene.protocol.pressure;
        if (pressure.trace() / 3.0 > 2e-3 * scene.contact.stiffness) continue;
        choices.push_back({fmt::format("pressure*{}", number_text(factor)),
                           {"protocol.pressure=" + pressure_text(pressure)}});
    }
}

void add_inertia(const Scene& scene, const JamState& start, std::vector<TradeChoice>& choices) {
    const double tau =
        unit_of_time(scene.contact, std::ranges::min(diameters_by_id(start.particles)));
    const auto add = [&](const char* name, const char* masses, double time_steps) {
        Scene other = scene;
        other.protocol.masses =
            std::string_view(masses) == "true" ? Masses::true_mass : Masses::diameter;
        TradeChoice choice{
            name,
            {"protocol.kind=nph", fmt::format("protocol.masses=\"{}\"", masses), limit_of_inertia}};
        if (time_steps != 1.0)
            choice.overrides.push_back(
                fmt::format("protocol.time_step={}",
                            number_text(time_steps * nph_settings(other, start).time_step / tau)));
        choices.push_back(std::move(choice));
    };
    add("nph,masses=true", "true", 1.0);
    add("nph,masses=diameter", "diameter", 1.0);
    add("nph,masses=diameter,time_step*3", "diameter", 3.0);
}

}  // namespace

std::vector<TradeChoice> trade_choices(const Scene& scene) {
    std::vector<TradeChoice> choices;
    for (const char* accuracy : {"paper", "standard", "fast"})
        choices.push_back(one_key("protocol.accuracy", accuracy));
    for (const char* rate : {"1e-3", "3e-4", "3e-5"})
        choices.push_back(one_key("protocol.descent_rate", rate));
    for (const char* cundall : {"1e-2", "3e-3", "3e-4"})
        choices.push_back(one_key("protocol.descent_cundall", cundall));
    add_tolerances(choices);
    const JamState start = start_state(scene);
    add_compactions(scene, start, choices);
    add_pressures(scene, choices);
    add_inertia(scene, start, choices);
    return choices;
}

// --- runs ---------------------------------------------------------------------------------------

std::vector<SweepRun> trade_runs(const std::filesystem::path& scene_file,
                                 const std::vector<std::string>& overrides,
                                 std::span<const TradeChoice> choices, int seeds,
                                 const std::filesystem::path& output) {
    const std::uint64_t first_seed = read_scene(scene_file, overrides).run.seed;
    std::vector<SweepRun> runs;
    for (int k = 0; k < seeds; ++k) {
        for (const TradeChoice& choice : choices) {
            const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(k);
            std::vector<std::string> all = overrides;
            all.insert(all.end(), choice.overrides.begin(), choice.overrides.end());
            all.push_back(fmt::format("run.seed={}", seed));
            SweepRun run{fmt::format("{}_seed={}", choice.name, seed), read_scene(scene_file, all)};
            run.scene.run.output = output / run.name;
            runs.push_back(std::move(run));
        }
    }
    return runs;
}

TradeResult read_trade_result(const SweepRun& run) {
    const std::filesystem::path& folder = run.scene.run.output;
    const Packing packing = load_packing(folder / "packing.h5");
    const JamState state = load_checkpoint(folder / "checkpoint.h5").state;
    TradeResult result;
    result.statistics = packing_statistics(packing, find_force_network(packing));
    result.pressure_error = pressure_error(result.statistics.pressure, run.scene.protocol);
    result.wall_seconds = state.wall_seconds;
    result.evaluations = static_cast<double>(state.step);
    result.converged = verdict_from_json(packing.provenance.verdict).converged();
    return result;
}

// --- points -------------------------------------------------------------------------------------

namespace {

MeanOverSeeds mean_over_seeds(std::span<const double> values) {
    const auto count = static_cast<double>(values.size());
    MeanOverSeeds out;
    for (const double value : values) out.mean += value / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - out.mean) * (value - out.mean);
    out.error = values.size() > 1 ? std::sqrt(squares / (count - 1.0) / count)
                                  : std::numeric_limits<double>::quiet_NaN();
    return out;
}

/// Results of one choice and of the reference, seed by seed.
struct ResultsOfChoice {
    std::vector<TradeResult> own, reference;

    template <typename Quantity>
    MeanOverSeeds mean(Quantity&& quantity) const {
        std::vector<double> values;
        for (const TradeResult& one : own) values.push_back(quantity(one));
        return mean_over_seeds(values);
    }
    MeanOverSeeds error(double PackingStatistics::*quantity) const {
        std::vector<double> values;
        for (std::size_t k = 0; k < own.size(); ++k)
            values.push_back(
                std::abs(own[k].statistics.*quantity - reference[k].statistics.*quantity));
        return mean_over_seeds(values);
    }
};

TradePoint point_of(const TradeChoice& choice, const ResultsOfChoice& results) {
    TradePoint point;
    point.name = choice.name;
    point.seeds = static_cast<int>(results.own.size());
    for (const TradeResult& one : results.own) point.converged += one.converged ? 1 : 0;
    point.wall_seconds = results.mean([](const TradeResult& one) { return one.wall_seconds; });
    point.evaluations = results.mean([](const TradeResult& one) { return one.evaluations; });
    point.volume_fraction = results.error(&PackingStatistics::volume_fraction);
    point.volume_fraction_nr = results.error(&PackingStatistics::volume_fraction_nr);
    point.coordination_nr = results.error(&PackingStatistics::coordination_nr);
    point.rattler_fraction = results.error(&PackingStatistics::rattler_fraction);
    point.pressure_error =
        results.mean([](const TradeResult& one) { return one.pressure_error; }).mean;
    return point;
}

/// Marks the points that no other beats in both evaluations and error: the Pareto front.
void mark_front(std::vector<TradePoint>& points, MeanOverSeeds TradePoint::*error,
                bool TradePoint::*mark) {
    for (TradePoint& point : points) {
        point.*mark = std::ranges::none_of(points, [&](const TradePoint& other) {
            const bool no_worse = other.evaluations.mean <= point.evaluations.mean &&
                                  (other.*error).mean <= (point.*error).mean;
            const bool better = other.evaluations.mean < point.evaluations.mean ||
                                (other.*error).mean < (point.*error).mean;
            return no_worse && better;
        });
    }
}

}  // namespace

std::vector<TradePoint> trade_points(std::span<const TradeChoice> choices,
                                     std::span<const TradeResult> results) {
    std::vector<TradePoint> points;
    for (std::size_t c = 0; c < choices.size(); ++c) {
        ResultsOfChoice of_choice;
        for (std::size_t k = c; k < results.size(); k += choices.size()) {
            of_choice.own.push_back(results[k]);
            of_choice.reference.push_back(results[k - c]);
        }
        points.push_back(point_of(choices[c], of_choice));
    }
    mark_front(points, &TradePoint::volume_fraction, &TradePoint::front_of_volume_fraction);
    mark_front(points, &TradePoint::coordination_nr, &TradePoint::front_of_coordination);
    return points;
}

std::string trade_csv(std::span<const TradePoint> points) {
    std::string out =
        "choice,seeds,converged,wall_seconds,evaluations,volume_fraction_error,"
        "volume_fraction_error_se,volume_fraction_nr_error,volume_fraction_nr_error_se,"
        "coordination_nr_error,coordination_nr_error_se,rattler_fraction_error,"
        "rattler_fraction_error_se,pressure_error,front_of_volume_fraction,"
        "front_of_coordination\n";
    const auto both = [](const MeanOverSeeds& value) {
        return fmt::format("{:.4g},{:.2g}", value.mean, value.error);
    };
    for (const TradePoint& point : points)
        out += fmt::format(
            "\"{}\",{},{},{:.4g},{:.6g},{},{},{},{},{:.2g},{},{}\n", point.name, point.seeds,
            point.converged, point.wall_seconds.mean, point.evaluations.mean,
            both(point.volume_fraction), both(point.volume_fraction_nr),
            both(point.coordination_nr), both(point.rattler_fraction), point.pressure_error,
            point.front_of_volume_fraction ? 1 : 0, point.front_of_coordination ? 1 : 0);
    return out;
}

}  // namespace jam
