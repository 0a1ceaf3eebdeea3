// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/relax_step.h"

#include "cell/upper_map.h"
#include "contacts/elastic_laws.h"
#include "core/lanes.h"
#include "jamming/cell_motion.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

constexpr int steps_between_renewals = 50;
constexpr double remembered = 0.99;  // of the fastest motion, a step

// What slides far is driven by a small share of the pressure, and must not be held back: in the
// metric's units slow modes turn over in 1 / sqrt(overlap), and friction is as weak as suits them.
// Fast modes are damped by forces that look ahead. And whoever runs into others must not shake them
// loose, so nobody goes faster than a few overlaps a step.
constexpr double friction_in_roots_of_overlap = 0.5;
/// However high the pressure: where sizes are wide much moves far more slowly than buckling.
constexpr double friction_at_high_pressure = 2e-3;
/// Modes of a packing without contacts to spare are spread evenly down to the slowest, which is so
/// many times slower than the fastest as there are contacts: less friction than it needs is of no
/// use.
constexpr double friction_per_contact = 3.0;
constexpr double most_friction = 0.5;         // of a velocity in a step
constexpr double fastest_in_overlaps = 20.0;  // in a step, of the smallest spheres
/// The same in mean overlaps, which are more where small spheres bear nothing.
constexpr double fastest_in_mean_overlaps = 1.0;

/// While a particle touches nothing, in that of the others. What slides along pushes rattlers
/// before it and gives all that they lose; but what they keep heats the others.
constexpr double friction_of_loose_ones = 0.2;
/// In top speeds: below it they stop, for nobody is pushed along so slowly.
constexpr double standstill_of_loose_ones = 1e-4;

double sum_of_forces(std::span<const Index> awake, const std::vector<Load>& loads) {
    double sum = 0.0;
    for_each_quad(
        awake, [](std::size_t) {},
        [&](const Quad& quad) {
            const Columns4 load = load_columns(loads, quad);
            const Double4 squared = squared_length(load);
            for (int k = 0; k < quad.count; ++k) sum += std::sqrt(squared[k]);
        });
    return sum;
}

void use_metric(const JamState& state, RelaxScratch& scratch) {
    set_metric(state.relax.stiffness, state.particles, scratch.active, scratch.metric);
}

/// Forces over tiles and slots, and what follows from them: who is awake, and the metric of those
/// who were not before.
void evaluate(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    const StageTimer timer(scratch.times, Stage::forces);
    Particles& particles = state.particles;
    scratch.sums =
        live_contact_forces(state.cell, settings.material, scratch.lists.tiles,
                            scratch.active.stirred, particles, particles.loads, scratch.forces);
    stir(scratch.forces.woken_of_tile, scratch.active);
    stir_live_tiles(scratch.lists.tiles, scratch.active.newly_stirred, scratch.forces);
    scratch.net_force = sum_active(scratch.active, 0.0, [&](Count block) {
        add_halo_loads(scratch.lists.tiles, block, scratch.forces.slots, particles.loads);
        find_awake(particles, block, scratch.active);
        return sum_of_forces(scratch.active.awake_of_block(block), particles.loads);
    });
    state.pressure = scratch.sums.virial / state.cell.volume();
    if (!state.relax.stiffness.empty()) use_metric(state, scratch);
}

/// Of the contacts that there are; zero without any.
double mean_overlap(const RelaxScratch& scratch, const Material& material, double smallest) {
    if (scratch.sums.contacts == 0) return 0.0;
    const double force = scratch.sums.force_magnitudes / static_cast<double>(scratch.sums.contacts);
    return overlap_of_force(material, force, smallest);
}

/// How velocities and places change in one step: v' = keep v + push M^-1 F, x' = x + back v +
/// forth v', with keep_loose in place of keep for who touches nothing; and how fast a particle may
/// be.
struct Move {
    double keep, keep_loose, push, back, forth, top_speed;
};

/// What is kept as a place is where the particle will be `look_ahead` later, x + look_ahead v, so
/// that forces are felt before their time: a mode of frequency w loses w^2 look_ahead of its
/// velocity, whichever way it goes (Nesterov, Doklady Akad. Nauk SSSR 269, 543, 1983).
Move next_move(const RelaxSettings& settings, const RelaxScratch& scratch) {
    const double smallest_diameter = scratch.lists.smallest_diameter;
    const double overlap =
        relative_overlap(settings.material, settings.pressure.trace() / 3.0, smallest_diameter);
    const double of_slow_modes =
        std::min(friction_in_roots_of_overlap * std::sqrt(overlap), friction_at_high_pressure);
    const double of_the_slowest =
        friction_per_contact / static_cast<double>(scratch.sums.contacts + 1);
    const double loss =
        std::min(most_friction, std::max(of_slow_modes, of_the_slowest) * settings.time_step);
    const double farthest = std::max(
        fastest_in_overlaps * overlap * smallest_diameter,
        fastest_in_mean_overlaps * mean_overlap(scratch, settings.material, smallest_diameter));
    return {.keep = 1.0 - loss,
            .keep_loose = 1.0 - friction_of_loose_ones * loss,
            .push = settings.time_step,
            .back = -settings.look_ahead,
            .forth = settings.time_step + settings.look_ahead,
            .top_speed =
                std::min(settings.largest_move * smallest_diameter, farthest) / settings.time_step};
}

/// Moves on the cell's rate of strain and returns the strain of this step.
Mat3 strain_of_step(JamState& state, const RelaxSettings& settings, const Move& move,
                    const Mat3& push) {
    const Mat3 before = state.velocity_gradient;
    Mat3& rate = state.velocity_gradient;
    rate = move.keep * before + move.push * push;
    const double strain = rate.norm() * move.push;
    if (strain > settings.largest_strain) rate *= settings.largest_strain / strain;
    return move.back * before + move.forth * rate;
}

/// Moves four particles after four others.
class Mover {
  public:
    Mover(JamState& state, const Move& move, const PeriodicCell& halfway,
          const RelaxScratch& scratch)
        : particles_(state.particles),
          move_(move),
          to_fractional_(halfway.inverse()),
          top_speed_(move.top_speed),
          metric_(scratch.metric.particles) {}

    void expect(std::size_t i) const {
        expect_read(particles_.loads[i]);
        expect_write(particles_.motions[i]);
        expect_read(metric_[i]);
        expect_write(particles_.spheres[i]);
    }

    /// Returns how far each has gone, squared.
    Double4 operator()(const Quad& quad) const {
        const Columns4 load = load_columns(particles_.loads, quad);
        const Columns4 before = load_columns(particles_.motions, quad);
        const Columns4 after = motion(before, load, load_responses(metric_, quad));
        store_columns(after, quad, particles_.motions);
        const Columns4 step = {before.x * move_.back + after.x * move_.forth,
                               before.y * move_.back + after.y * move_.forth,
                               before.z * move_.back + after.z * move_.forth, Double4{}};
        const Columns4 change = to_fractional_(step);
        Columns4 sphere = load_columns(particles_.spheres, quad);
        sphere.x += change.x;
        sphere.y += change.y;
        sphere.z += change.z;
        store_columns(sphere, quad, particles_.spheres);
        return squared_length(step);
    }

  private:
    Columns4 motion(const Columns4& before, const Columns4& load,
                    const QuadResponse& metric) const {
        const Mask4 touches = load.w > 0.0;
        const Double4 keep = touches ? Double4{} + move_.keep : Double4{} + move_.keep_loose;
        const Columns4 push = metric(load);
        Columns4 after = {before.x * keep + push.x * move_.push,
                          before.y * keep + push.y * move_.push,
                          before.z * keep + push.z * move_.push, metric.mass};
        Double4 squared = squared_length(after);
        const Mask4 too_fast = squared > Double4{} + top_speed_ * top_speed_;
        if (bits_of(too_fast) != 0) scale(too_fast, squared, after);
        const double standstill = standstill_of_loose_ones * top_speed_;
        const Mask4 stops = ~touches & (squared < Double4{} + standstill * standstill);
        after.x = stops ? Double4{} : after.x;
        after.y = stops ? Double4{} : after.y;
        after.z = stops ? Double4{} : after.z;
        // Who is idle depends on the state alone, who is active on the tiles, too: what the idle
        // ones have must not.
        const Mask4 idle = ~touches & (squared_length(before) == Double4{});
        after.w = idle ? before.w : after.w;
        return after;
    }

    void scale(const Mask4& too_fast, const Double4& squared, Columns4& after) const {
        for (int k = 0; k < 4; ++k) {
            const double factor = too_fast[k] ? top_speed_ / std::sqrt(squared[k]) : 1.0;
            after.x[k] *= factor;
            after.y[k] *= factor;
            after.z[k] *= factor;
        }
    }

    Particles& particles_;
    Move move_;
    UpperMap to_fractional_;
    double top_speed_;
    const std::vector<BlockResponse>& metric_;
};

/// Returns how far the one that goes farthest goes.
double move_particles(const ActiveParticles& active, const Mover& mover) {
    const double squared = max_blocks(active.block_count(), 1, [&](Count block, Count) {
        Double4 largest{};
        const auto expect = [&](std::size_t i) { mover.expect(i); };
        for_each_quad(active.awake_of_block(block), expect, [&](const Quad& quad) {
            const Double4 moved = mover(quad);
            largest = moved > largest ? moved : largest;
        });
        return std::max({largest[0], largest[1], largest[2], largest[3]});
    });
    return std::sqrt(squared);
}

void renew_metric(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    const double smallest = scratch.lists.smallest_diameter;
    const double overlap = mean_overlap(scratch, settings.material, smallest);
    renew_stiffness(scratch.full, state.cell, settings.material, overlap, state.particles,
                    scratch.active, state.relax.stiffness);
    forget_metric(state.particles, scratch.metric);
    state.relax.renewal_age = 0;
}

void begin_tiles(const JamState& state, RelaxScratch& scratch) {
    begin_stirring(state.particles, scratch.active);
    scratch.metric.set_of_block.clear();
    begin_live_tiles(scratch.lists.tiles, scratch.forces);
}

void search(JamState& state, const StepMotion& moved, RelaxScratch& scratch) {
    const StageTimer timer(scratch.times, Stage::search);
    reduce_tilt(state);
    renew_lists(scratch.lists, state.cell, moved, scratch.motion, state.particles);
    state.list_reference = scratch.lists.outer;
    scratch.full = full_list(scratch.lists.candidates);
    forget_metric(state.particles, scratch.metric);
}

/// What moved lately will move again: it stands still for a while only because it began anew.
void expect_more_of(const StepMotion& moved, StepMotion& expected) {
    expected.displacement = std::max(moved.displacement, remembered * expected.displacement);
    expected.strain = std::max(moved.strain, remembered * expected.strain);
}

void keep_lists_valid(JamState& state, const StepMotion& moved, RelaxScratch& scratch) {
    ListRenewal renewal;
    {
        const StageTimer timer(scratch.times, Stage::refilter);
        renewal =
            keep_tiles_valid(scratch.lists, state.cell, moved, scratch.motion, state.particles);
    }
    if (renewal == ListRenewal::none) return;
    if (renewal == ListRenewal::search_needed) search(state, moved, scratch);
    begin_tiles(state, scratch);
}

}  // namespace

double relative_overlap(const Material& material, double pressure, double smallest_diameter) {
    const double force = pressure * smallest_diameter * smallest_diameter;
    return overlap_of_force(material, force, smallest_diameter) / smallest_diameter;
}

void begin_relaxation(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    if (state.list_reference.centers.empty()) {
        scratch.lists.hierarchy.group(state.particles);
        search(state, StepMotion{}, scratch);
    } else {
        restore_lists(scratch.lists, state.list_reference, state.cell, scratch.motion,
                      state.particles);
        scratch.full = full_list(scratch.lists.candidates);
    }
    begin_tiles(state, scratch);
    forget_metric(state.particles, scratch.metric);
    if (state.relax.stiffness.empty()) {
        evaluate(state, settings, scratch);  // for the mean overlap
        renew_metric(state, settings, scratch);
    }
    evaluate(state, settings, scratch);
}

void relax_step(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    RelaxState& relax = state.relax;
    if (++relax.renewal_age >= steps_between_renewals) {
        const StageTimer timer(scratch.times, Stage::metric);
        renew_metric(state, settings, scratch);
        use_metric(state, scratch);
    }
    const Mat3& inertia = scratch.metric.cell_inertia;
    const Mat3 cell_force = allowed_strain(
        state.cell.volume() * (state.pressure - settings.pressure), settings.free_cell);
    const Mat3 cell_push = allowed_strain(cell_force.cwiseQuotient(inertia), settings.free_cell);
    const Move move = next_move(settings, scratch);
    const Mat3 strain = strain_of_step(state, settings, move, cell_push);
    const PeriodicCell halfway = strained_cell(state.cell, 0.5 * strain);
    state.cell = strained_cell(state.cell, strain);
    StepMotion moved{.displacement = 0.0, .strain = strain.norm()};
    {
        const StageTimer timer(scratch.times, Stage::integrate);
        moved.displacement = move_particles(scratch.active, Mover(state, move, halfway, scratch));
    }
    expect_more_of(moved, scratch.motion);
    keep_lists_valid(state, moved, scratch);
    evaluate(state, settings, scratch);
    ++state.step;
}

}  // namespace jam
