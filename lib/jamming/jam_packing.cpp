// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/jam_packing.h"

#include "core/check.h"
#include "jamming/nph_step.h"
#include "jamming/quasistatic.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace jam {

namespace {

/// Wall time of this sitting on top of the earlier ones.
class Stopwatch {
  public:
    explicit Stopwatch(double earlier) : earlier_(earlier) {}
    double sitting() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    double total() const { return earlier_ + sitting(); }

  private:
    double earlier_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Steps a second since the record before.
class Speedometer {
  public:
    double since_last(Count step, double seconds) {
        const double speed =
            last_ ? static_cast<double>(step - last_->step) / (seconds - last_->seconds)
                  : Record::unknown;
        last_ = Mark{step, seconds};
        return speed;
    }

  private:
    struct Mark {
        Count step;
        double seconds;
    };
    std::optional<Mark> last_;
};

double smallest_diameter(const Particles& particles) {
    return std::ranges::min_element(particles.spheres, {}, &Sphere::diameter)->diameter;
}

double dynamic_cundall(const JamState& state, const ContactSums& sums) {
    double net = 0.0;
    for (const Load& load : state.particles.loads) net += load.force.norm();
    return net / sums.force_magnitudes;
}

Record record_of(const JamState& state, const Measurement& measurement, const ContactSums& sums) {
    const PackingStatistics& now = measurement.statistics;
    Record record;
    record.step = state.step;
    record.time = state.time;
    record.volume_fraction = now.volume_fraction;
    record.coordination = now.coordination;
    record.coordination_nr = now.coordination_nr;
    record.rattler_fraction = now.rattler_fraction;
    record.pressure = now.pressure;
    record.pressure_dynamic = state.pressure;
    record.cundall = now.cundall;
    record.cundall_dynamic = dynamic_cundall(state, sums);
    record.kinetic_energy_per_particle = now.kinetic_energy_per_particle;
    record.cell = state.cell.matrix();
    record.wall_seconds = state.wall_seconds;
    return record;
}

/// Stability costs a factorization: asked for where a run may end, not at each record.
JamResult judged(const Scene& scene, const JamState& state, Measurement measurement,
                 bool ask_stability) {
    JamResult result;
    result.measurement = std::move(measurement);
    result.verdict = judge(result.measurement, state, scene, ask_stability);
    result.measurement.packing.provenance.verdict = to_json(result.verdict);
    return result;
}

/// A run by the nph protocol, one step at a time.
class NphRun {
  public:
    NphRun(const Scene& scene, JamState& state)
        : state_(state),
          settings_(nph_settings(scene, state)),
          scratch_(diameters_by_id(state.particles), scene.run.lists) {}

    void begin() { begin_nph(state_, settings_, scratch_); }
    void advance() { nph_step(state_, settings_, scratch_); }
    bool at_rest() const { return false; }
    const ContactSums& sums() const { return scratch_.sums; }
    const StepMotion& motion() const { return scratch_.motion; }
    double time_step() const { return settings_.time_step; }
    StageTimes times() const { return scratch_.times; }

  private:
    JamState& state_;
    NphSettings settings_;
    NphScratch scratch_;
};

/// Takes a method from step to step: limits, records, verdict, checkpoints.
template <typename Method>
class JamRun {
  public:
    JamRun(const Scene& scene, JamState& state, const JamHooks& hooks)
        : scene_(scene),
          state_(state),
          hooks_(hooks),
          method_(scene, state),
          smallest_diameter_(smallest_diameter(state.particles)),
          watch_(state.wall_seconds) {}

    JamResult run() {
        method_.begin();
        for (;;) {
            const Count before = state_.step;
            method_.advance();
            require_bounded_motion();
            const std::optional<JamOutcome> limit = reached_limit();
            if (passed(before, scene_.run.record_interval) || limit || method_.at_rest()) {
                JamResult result = measure_and_record(limit || method_.at_rest());
                const bool converged = result.verdict.converged();
                if (limit) result.outcome = *limit;
                if (converged) result.outcome = JamOutcome::converged;
                if (limit || converged) {
                    if (converged) state_.quasistatic.at_rest = true;
                    checkpoint();
                    return result;
                }
            }
            if (passed(before, scene_.run.checkpoint_interval)) checkpoint();
        }
    }

  private:
    /// Whether a multiple of `interval` has been reached since step `before`: an advance may be
    /// more than one step.
    bool passed(Count before, Count interval) const {
        return state_.step / interval != before / interval;
    }

    std::optional<JamOutcome> reached_limit() const {
        if (hooks_.stop_requested && hooks_.stop_requested()) return JamOutcome::interrupted;
        if (state_.step >= scene_.stop.max_steps) return JamOutcome::step_limit;
        if (scene_.stop.max_time > 0.0 && watch_.sitting() >= scene_.stop.max_time)
            return JamOutcome::time_limit;
        return std::nullopt;
    }

    JamResult measure_and_record(bool ask_stability) {
        state_.wall_seconds = watch_.total();
        JamResult result;
        {
            const StageTimer timer(times_, Stage::measure);
            Measurement measurement = measure(state_, scene_);
            // A stop between two records must leave no trace in the samples.
            if (state_.step % scene_.run.record_interval == 0)
                take_sample(measurement, scene_.stop, state_);
            result = judged(scene_, state_, std::move(measurement), ask_stability);
        }
        result.times = method_.times();
        result.times += times_;
        Record record = record_of(state_, result.measurement, method_.sums());
        record.steps_per_second = speedometer_.since_last(state_.step, state_.wall_seconds);
        if (hooks_.on_record) hooks_.on_record(record, result.verdict);
        return result;
    }

    void checkpoint() {
        state_.wall_seconds = watch_.total();
        const StageTimer timer(times_, Stage::save);
        if (hooks_.on_checkpoint) hooks_.on_checkpoint(state_);
    }

    /// A step that carries a particle across another, or strains the cell by a tenth, has nothing
    /// to do with the motion any more.
    void require_bounded_motion() const {
        const StepMotion& motion = method_.motion();
        const bool bounded = motion.displacement < 0.5 * smallest_diameter_ &&
                             motion.strain < 0.1 && std::isfinite(state_.pressure.sum());
        if (bounded) return;
        const double step = method_.time_step() / unit_of_time(scene_.contact, smallest_diameter_);
        throw InputError(fmt::format(
            "protocol.time_step = {}: the motion has become unbounded at step {}; the time step "
            "must stay below the stability limit: use a smaller one, such as {:.3g}",
            scene_.protocol.time_step ? fmt::format("{:.6g}", step)
                                      : fmt::format("\"automatic\" ({:.4g} here)", step),
            state_.step, 0.5 * step));
    }

    const Scene& scene_;
    JamState& state_;
    const JamHooks& hooks_;
    Method method_;
    double smallest_diameter_;
    StageTimes times_;  ///< of measuring and saving
    Stopwatch watch_;
    Speedometer speedometer_;
};

}  // namespace

void require_stable_time_step(const Scene& scene, const JamState& state) {
    if (!scene.protocol.time_step) return;
    Particles particles = state.particles;
    Material material = scene.contact;
    if (scene.protocol.kind == ProtocolKind::quasistatic) {
        set_masses(particles, Masses::diameter, scene.contact.density);
        material.damping = quasistatic_settings(scene, state).compaction.material.damping;
    }
    const double tau = unit_of_time(scene.contact, smallest_diameter(particles));
    const double limit = stability_limit(material, particles) / tau;
    require(
        *scene.protocol.time_step <= limit,
        "protocol.time_step = {:.6g}: above the stability limit of the stiffest particle, {:.4g} "
        "here; use a smaller one, such as {:.3g}, or protocol.time_step = \"automatic\"",
        *scene.protocol.time_step, limit, 0.25 * limit);
}

std::optional<JamResult> ending_without_a_step(const Scene& scene, const JamState& state) {
    const bool at_record = state.step > 0 && state.step % scene.run.record_interval == 0;
    const bool at_limit = state.step >= scene.stop.max_steps;
    const bool at_rest = state.quasistatic.at_rest;
    if (!at_record && !at_limit && !at_rest) return std::nullopt;
    JamResult result = judged(scene, state, measure(state, scene), at_limit || at_rest);
    if (!result.verdict.converged() && !at_limit) return std::nullopt;
    result.outcome = result.verdict.converged() ? JamOutcome::converged : JamOutcome::step_limit;
    return result;
}

JamResult jam_packing(const Scene& scene, JamState& state, const JamHooks& hooks) {
    require_stable_time_step(scene, state);
    return run_with_threads(scene.run.threads, [&] {
        if (scene.protocol.kind == ProtocolKind::nph)
            return JamRun<NphRun>(scene, state, hooks).run();
        return JamRun<QuasistaticRun>(scene, state, hooks).run();
    });
}

}  // namespace jam
