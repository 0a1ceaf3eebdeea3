// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/quasistatic.h"

#include "contacts/elastic_laws.h"
#include "jamming/convergence.h"
#include "jamming/saddle_leap.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace jam {

namespace {

/// The automatic step is cautious enough for masses that a scene may choose; compaction chooses
/// its own.
constexpr double compaction_step_in_automatic_ones = 4.0;
/// Under a pressure as high as the stiffness the cell moves as fast as the spheres: its step, over
/// the time in which the pressure sets it in motion.
constexpr double longest_step_of_the_cell = 0.03;
/// Compaction is no faster for more damping than this, and needs shorter steps; over the time step.
constexpr double heaviest_damping = 0.3;
/// A start that presses this many times as hard as compaction would is compact already, and would
/// fly apart by inertia.
constexpr double too_compact = 10.0;
constexpr double reference_overlap = 1e-3;  // in smallest diameters
constexpr double reference_width = 5.0;     // mean diameter by volume, in smallest ones
constexpr Count steps_between_looks = 10;

// Events pass one after the other in a small packing and side by side in a large one: with fewer
// contacts than this there are fewer to pass, and the pressure may fall faster by as much; but not
// faster than the slowest of them turns over.
constexpr double many_contacts = 10'000.0;
/// Of the fastest, however far from balance forces are, where the pressure may not rise.
constexpr double slowest_descent = 0.01;
/// In the limit: up to here the pressure waits, where it may rise beyond.
constexpr double cundall_to_rise = 2.0;
/// Of the fastest descent, from one limit beyond that on.
constexpr double fastest_rise = 0.3;
/// Over the lowest pressure of this descent: what must go farther up for a small event would have
/// all of that way to go down again.
constexpr double farthest_rise = 2.0;
/// At a pressure that overlaps equal spheres by 1e-4.
constexpr double turn_at_full_limit = 1e-2;
/// Of the full one; it stands above the round-off of forces.
constexpr double least_limit = 0.1;

// When Newton's method is worth a trial, and how long to relax at least before the next: one that
// fails takes a tenth of the time so far at most, and what has failed is tried ever more rarely,
// unless what it starts from is far nearer to rest. It leaves no trace.
constexpr double cundall_for_newton = 1e-5;
constexpr double cundall_for_a_late_trial = 1e-4;
constexpr Count steps_to_a_late_trial = 10'000;
constexpr Count steps_between_trials = 5'000;
constexpr Count steps_between_trials_in_their_cost = 10;
constexpr double nearer_for_a_trial = 0.1;       // than at the last
constexpr double operations_a_particle = 600.0;  // in a factorization's time, awake, in a step
constexpr double factorizations_of_a_failure = 25.0;

// How often to ask whether the relaxation has come to rest by itself: the answer takes a
// factorization, so it is asked for half as often each time that a long wait doubles its length, at
// the foot or at rest there.
constexpr Count steps_between_verdicts = 2'000;
constexpr Count steps_of_a_long_wait = 100'000;
constexpr Count steps_of_a_long_rest = 8'000;

// At a saddle C is small, and grows. Leaps are long enough to leave it: with a tenth of the length
// a run swings about it. One look after a verdict, so that what is judged is what came to rest.
constexpr double cundall_at_a_saddle = 3.0;  // in the tolerated one
constexpr double growth_at_a_saddle = 1.02;
constexpr double longest_leap = 1e-3;  // in smallest diameters

// The pressure is raised to descend anew when for so many steps, whenever asked, contacts have been
// missing to isostaticity, or what rests was not taken for jammed: a mode so weakly unstable that
// nothing leaves it. Contacts flicker while an event passes, so one look proves nothing; and while
// the network stands the foot is where it comes to rest soonest.
constexpr Count patience = 64'000;
constexpr Count steps_between_counts = 2'000;
constexpr double climb_in_pressure = 4.0;

/// The automatic one of the settings, made longer.
double compaction_time_step(const QuasistaticSettings& settings,
                            const std::vector<double>& diameters) {
    double volume = 0.0;
    for (const double diameter : diameters) volume += sphere_volume(diameter);
    const double cell_rate =
        std::sqrt(settings.first_pressure * volume / settings.compaction.cell_inertia);
    return std::min(compaction_step_in_automatic_ones * settings.compaction.time_step,
                    longest_step_of_the_cell / cell_rate);
}

Count verdict_interval(Count steps_at_foot, Count steps_at_rest) {
    const Count lengths = std::max<Count>(
        {1, steps_at_foot / steps_of_a_long_wait, steps_at_rest / steps_of_a_long_rest});
    return steps_between_verdicts *
           static_cast<Count>(std::bit_floor(static_cast<std::uint64_t>(lengths)));
}

/// Those of a factorization in the time of a step.
double operations_of_a_step(Count awake) {
    return operations_a_particle * static_cast<double>(std::max(awake, Count{1}));
}

/// What one factorization may take, so that a failure takes a tenth of the time of so many steps.
double affordable_operations(Count steps, Count awake) {
    const Count tenth = std::max(steps_between_trials, steps / steps_between_trials_in_their_cost);
    return static_cast<double>(tenth) * operations_of_a_step(awake) / factorizations_of_a_failure;
}

/// Steps that would have taken the time of these factorizations.
Count cost_in_steps(const NewtonResult& newton, Count awake) {
    return static_cast<Count>(newton.factorizations * newton.operations /
                              operations_of_a_step(awake));
}

/// Particles and cell, with lists to be made anew.
void bring_to_standstill(JamState& state) {
    for (Motion& motion : state.particles.motions) motion.velocity.setZero();
    state.velocity_gradient.setZero();
    state.list_reference = {};
}

/// Of the fastest descent, negative for a rise: what is out of balance slows the fall, at its limit
/// all but stops it, and from twice that on turns it round.
double share_of_descent(double cundall_in_limits, bool may_rise) {
    const double beyond = cundall_in_limits - cundall_to_rise;
    if (may_rise && beyond > 0.0) return -fastest_rise * std::min(beyond, 1.0);
    const double left = 1.0 - cundall_in_limits;
    return left > slowest_descent ? left : slowest_descent;
}

bool is_isotropic(const Mat3& pressure) {
    return pressure == Mat3(Mat3::Identity() * pressure(0, 0));
}

}  // namespace

double automatic_compaction_pressure(const Material& material, std::span<const double> diameters) {
    const double smallest = *std::ranges::min_element(diameters);
    double cubes = 0.0;
    double fourths = 0.0;
    for (const double diameter : diameters) {
        cubes += std::pow(diameter, 3);
        fourths += std::pow(diameter, 4);
    }
    const double width = fourths / cubes / smallest;
    const double force = with_elastic_law(material, [&](const auto& law) {
        return law.force(reference_overlap * smallest, smallest, smallest);
    });
    return force / (smallest * smallest) * std::min(1.0, reference_width / width);
}

QuasistaticSettings quasistatic_settings(const Scene& scene, const JamState& state) {
    const ProtocolSettings& protocol = scene.protocol;
    QuasistaticSettings settings;
    settings.descent = protocol.descent;
    settings.stop = scene.stop;
    settings.applied_pressure = protocol.pressure.trace() / 3.0;
    const std::vector<double> diameters = diameters_by_id(state.particles);
    const double automatic = automatic_compaction_pressure(scene.contact, diameters);
    settings.first_pressure = std::max(protocol.descent.compaction_pressure.value_or(automatic),
                                       settings.applied_pressure);
    settings.climbed_pressure = std::min(std::max(automatic, settings.first_pressure),
                                         climb_in_pressure * settings.applied_pressure);

    Scene compaction = scene;
    compaction.protocol.masses = Masses::diameter;
    compaction.protocol.pressure *= settings.first_pressure / settings.applied_pressure;
    compaction.contact.damping = 0.0;
    settings.compaction = nph_settings(compaction, state);
    if (!protocol.time_step)
        settings.compaction.time_step = compaction_time_step(settings, diameters);
    settings.compaction.material.damping =
        std::min(scene.contact.damping, heaviest_damping / settings.compaction.time_step);

    settings.relax = {
        .material = scene.contact, .pressure = protocol.pressure, .free_cell = protocol.free_cell};
    settings.newton = {.material = scene.contact,
                       .pressure = settings.applied_pressure,
                       .cundall = 0.1 * scene.stop.cundall};
    settings.newton_serves = protocol.free_cell == FreeCell::all && is_isotropic(protocol.pressure);
    return settings;
}

QuasistaticRun::QuasistaticRun(const Scene& scene, JamState& state)
    : scene_(scene),
      state_(state),
      protocol_(scene.protocol),
      lists_(scene.run.lists),
      diameters_(diameters_by_id(state.particles)) {
    if (state.quasistatic.pressure == 0.0 && !state.particles.motions.empty())
        set_masses(state.particles, Masses::diameter, scene.contact.density);
    settings_ = quasistatic_settings(scene, state);
}

bool QuasistaticRun::compacting() const {
    return state_.quasistatic.stage == QuasistaticState::Stage::compaction;
}

bool QuasistaticRun::at_foot() const {
    return state_.quasistatic.pressure <= settings_.applied_pressure;
}

Mat3 QuasistaticRun::pressure_now() const {
    return protocol_.pressure * (state_.quasistatic.pressure / settings_.applied_pressure);
}

const ContactSums& QuasistaticRun::sums() const {
    return compacting() ? compaction_->sums : relaxation_->sums;
}

const StepMotion& QuasistaticRun::motion() const {
    return compacting() ? compaction_->motion : relaxation_->motion;
}

StageTimes QuasistaticRun::times() const {
    StageTimes sum;
    if (compaction_) sum += compaction_->times;
    if (relaxation_) sum += relaxation_->times;
    return sum;
}

void QuasistaticRun::begin() {
    if (state_.quasistatic.pressure == 0.0) state_.quasistatic.pressure = settings_.first_pressure;
    if (compacting()) {
        compaction_.emplace(diameters_, lists_);
        begin_nph(state_, settings_.compaction, *compaction_);
        const double pressure = state_.pressure.trace() / 3.0;
        if (state_.step == 0 && pressure > too_compact * settings_.first_pressure) begin_descent();
    } else {
        relaxation_.emplace(diameters_, lists_);
        settings_.relax.pressure = pressure_now();
        begin_relaxation(state_, settings_.relax, *relaxation_);
    }
}

void QuasistaticRun::advance() {
    state_.quasistatic.at_rest = false;
    if (!compacting()) {
        relax();
        return;
    }
    if (state_.step < settings_.descent.compaction_steps)
        nph_step(state_, settings_.compaction, *compaction_);
    if (state_.step >= settings_.descent.compaction_steps) begin_descent();
}

void QuasistaticRun::begin_descent() {
    bring_to_standstill(state_);
    state_.quasistatic.stage = QuasistaticState::Stage::relaxation;
    relaxation_.emplace(diameters_, lists_);
    begin_descent_from(state_.quasistatic.pressure);
    begin_relaxation(state_, settings_.relax, *relaxation_);
}

void QuasistaticRun::begin_descent_from(double pressure) {
    state_.quasistatic.lowest_pressure = pressure;
    apply(pressure);
}

void QuasistaticRun::apply(double pressure) {
    state_.quasistatic.pressure = std::max(pressure, settings_.applied_pressure);
    state_.quasistatic.lowest_pressure =
        std::min(state_.quasistatic.lowest_pressure, state_.quasistatic.pressure);
    state_.quasistatic.foot_begin = state_.step;
    state_.quasistatic.last_whole = state_.step;
    state_.quasistatic.leap = {};
    settings_.relax.pressure = pressure_now();
}

void QuasistaticRun::relax() {
    relax_step(state_, settings_.relax, *relaxation_);
    const double share = share_of_descent(cundall_in_limits(), may_rise());
    if (!at_foot() || share < 0.0)
        descend(share);
    else if ((state_.step - state_.quasistatic.foot_begin) % steps_between_looks == 0)
        finish();
}

void QuasistaticRun::descend(double share) {
    const double pressure = state_.quasistatic.pressure * std::exp(-fastest_descent() * share);
    apply(std::min(pressure, highest_pressure()));
}

double QuasistaticRun::highest_pressure() const {
    return std::min(std::max(settings_.first_pressure, settings_.climbed_pressure),
                    farthest_rise * state_.quasistatic.lowest_pressure);
}

/// The limit falls with the pressure, since a network that flows at a share of its forces closes
/// fewer contacts than it opens where the overlaps are small.
double QuasistaticRun::cundall_in_limits() const {
    const double turn = slowest_turn();
    const double share_of_limit = std::clamp(turn / turn_at_full_limit, least_limit, 1.0);
    const double limit = std::min(settings_.descent.cundall * share_of_limit, turn);
    return relaxation_->cundall() / limit;
}

/// Where the limit falls: an event ends the sooner the harder it is pressed, and the network that
/// it leaves behind is whole. Small packings, of few events, would go up and down without end.
bool QuasistaticRun::may_rise() const {
    const bool limit_falls = slowest_turn() < turn_at_full_limit;
    const bool large = static_cast<double>(relaxation_->sums.contacts) > many_contacts;
    return limit_falls && large && state_.quasistatic.pressure < highest_pressure();
}

double QuasistaticRun::slowest_turn() const {
    return std::sqrt(relative_overlap(scene_.contact, state_.quasistatic.pressure,
                                      relaxation_->lists.smallest_diameter));
}

double QuasistaticRun::fastest_descent() const {
    const double contacts = static_cast<double>(relaxation_->sums.contacts) + 1.0;
    const double rate = settings_.descent.rate * std::max(1.0, many_contacts / contacts);
    return std::min(rate, slowest_turn()) * std::pow(0.5, state_.quasistatic.retreats);
}

void QuasistaticRun::finish() {
    const Count steps = state_.step - state_.quasistatic.foot_begin;
    const double cundall = relaxation_->cundall();
    const bool near = cundall <= cundall_for_newton ||
                      (steps >= steps_to_a_late_trial && cundall <= cundall_for_a_late_trial);
    const bool due = state_.step >= state_.quasistatic.next_trial ||
                     cundall <= nearer_for_a_trial * state_.quasistatic.trial_cundall;
    const bool balanced = near && due && settings_.newton_serves && try_newton();
    const Count interval = verdict_interval(steps, state_.step - state_.quasistatic.last_whole);
    if (balanced || steps % interval == 0)
        state_.quasistatic.at_rest =
            relaxation_->cundall() <= settings_.stop.cundall &&
            pressure_error(state_.pressure, protocol_) <= settings_.stop.pressure;
    if (steps % interval == steps_between_looks) leap_from_saddle();
    if (steps % steps_between_counts == 0) look_whether_whole();
}

void QuasistaticRun::leap_from_saddle() {
    LeapReference& before = state_.quasistatic.leap;
    const double cundall = relaxation_->cundall();
    const bool near = cundall <= cundall_at_a_saddle * settings_.stop.cundall;
    const bool leaves = !before.centers.empty() && cundall > growth_at_a_saddle * before.cundall;
    if (near && leaves) {
        const double smallest = relaxation_->lists.smallest_diameter;
        leap(before, state_.cell, longest_leap * smallest, state_.particles);
        state_.list_reference = {};
        before = {};
        begin_relaxation(state_, settings_.relax, *relaxation_);
    } else {
        before = near ? leap_reference(state_.particles, cundall) : LeapReference{};
    }
}

void QuasistaticRun::look_whether_whole() {
    const bool rests = relaxation_->cundall() <= settings_.stop.cundall;
    if (!rests && excess_contact_count_of_held(to_packing(state_, scene_)) >= 0)
        state_.quasistatic.last_whole = state_.step;
    else if (state_.step - state_.quasistatic.last_whole >= patience)
        climb();
}

void QuasistaticRun::climb() {
    if (settings_.climbed_pressure <= settings_.applied_pressure) return;
    ++state_.quasistatic.retreats;
    state_.quasistatic.next_trial = state_.step;
    state_.quasistatic.trial_cundall = 0.0;
    begin_descent_from(settings_.climbed_pressure);
}

bool QuasistaticRun::try_newton() {
    RelaxScratch& scratch = *relaxation_;
    const Count awake = scratch.active.awake_count();
    NewtonSettings settings = settings_.newton;
    settings.most_operations = affordable_operations(state_.step, awake);
    NewtonResult result;
    {
        const StageTimer timer(scratch.times, Stage::newton);
        result = newton_relax(settings, scratch.lists.candidates, scratch.lists.smallest_diameter,
                              state_.cell, state_.particles);
    }
    const Count steps_at_foot = state_.step - state_.quasistatic.foot_begin;
    const Count pause =
        result.tried ? std::max({steps_between_trials, steps_at_foot,
                                 steps_between_trials_in_their_cost * cost_in_steps(result, awake)})
                     : state_.step;
    state_.quasistatic.next_trial = state_.step + pause;
    state_.quasistatic.trial_cundall = result.tried ? scratch.cundall() : 0.0;
    if (!result.converged) return false;
    bring_to_standstill(state_);
    state_.quasistatic.leap = {};
    state_.step += result.factorizations;
    begin_relaxation(state_, settings_.relax, scratch);
    return true;
}

}  // namespace jam
