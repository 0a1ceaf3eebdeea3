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

// FIRE's own numbers, as published, but for the shorter cut of the time step.
constexpr double first_mixing = 0.1;
constexpr double mixing_decay = 0.99;
constexpr double growth = 1.05;
constexpr double cut = 0.6;
constexpr int steps_before_growth = 10;

/// Share of its velocity that a particle keeps in a step while it touches nothing. It must hardly
/// lose any: what slides along pushes rattlers before it, and all that they lose it has to give.
constexpr double kept_by_loose_ones = 0.999;

Double4 dot(const Columns4& a, const Columns4& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double squared_norm(const Mat3& inertia, const Mat3& rate) {
    return inertia.cwiseProduct(rate).cwiseProduct(rate).sum();
}

/// What the particles add to the decision about the next step.
struct DescentSums {
    double power = 0.0;
    double push_squared = 0.0;
    double net_force = 0.0;

    DescentSums& operator+=(const DescentSums& other) {
        power += other.power;
        push_squared += other.push_squared;
        net_force += other.net_force;
        return *this;
    }
};

/// Forces over tiles and slots, and what follows from them.
void evaluate(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    const StageTimer timer(scratch.times, Stage::forces);
    Particles& particles = state.particles;
    scratch.sums = contact_forces(state.cell, settings.material, {}, scratch.lists.tiles, particles,
                                  particles.loads, scratch.forces);
    const auto add_block = [&](Count block) {
        add_halo_loads(scratch.lists.tiles, block, scratch.forces.slots, particles.loads);
        find_awake(particles, block, scratch.active);
        DescentSums sums;
        const auto expect = [&](std::size_t i) { expect_read(scratch.metric.particles[i]); };
        for_each_quad(scratch.active.awake_of_block(block), expect, [&](const Quad& quad) {
            const Columns4 load = load_columns(particles.loads, quad);
            const Columns4 motion = load_columns(particles.motions, quad);
            const QuadResponse metric = load_responses(scratch.metric.particles, quad);
            const Double4 power = dot(load, motion);
            const Double4 push_squared = dot(load, metric(load));
            const Double4 squared = dot(load, load);
            for (int k = 0; k < quad.count; ++k)
                sums += {power[k], push_squared[k], std::sqrt(squared[k])};
        });
        return sums;
    };
    const DescentSums sums = sum_active(scratch.active, DescentSums{}, add_block);
    state.pressure = scratch.sums.virial / state.cell.volume();
    scratch.power = sums.power;
    scratch.push_squared = sums.push_squared;
    scratch.net_force = sums.net_force;
}

/// How velocities and places change in one step: v' = keep v + push M^-1 F, x' = x + back v + dt
/// v'.
struct Move {
    double keep, push, back, time_step;
};

/// Downhill the velocity turns towards the force and the step grows; uphill the last half step is
/// taken back and the motion begins anew.
Move next_move(RelaxState& relax, double power, double push_squared, double largest_time_step) {
    if (power < 0.0) {
        const double before = relax.time_step;
        relax.time_step *= cut;
        relax.mixing = first_mixing;
        relax.steps_downhill = 0;
        return {0.0, relax.time_step, -0.5 * before, relax.time_step};
    }
    if (++relax.steps_downhill > steps_before_growth) {
        relax.time_step = std::min(growth * relax.time_step, largest_time_step);
        relax.mixing *= mixing_decay;
    }
    const double turn = push_squared > 0.0 ? std::sqrt(relax.speed_squared / push_squared) : 0.0;
    return {1.0 - relax.mixing, relax.mixing * turn + relax.time_step, 0.0, relax.time_step};
}

/// v' . M v' from the sums over v and F before: exact but for what the caps on the motion take away
/// and the metric's renewal changes, both of which the next motion uphill forgets.
double speed_squared_after(double before, const Move& move, double power, double push_squared) {
    return std::max(0.0, move.keep * move.keep * before + 2.0 * move.keep * move.push * power +
                             move.push * move.push * push_squared);
}

/// Moves on the cell's rate of strain and returns the strain of this step.
Mat3 strain_of_step(JamState& state, const RelaxSettings& settings, const Move& move,
                    const Mat3& push) {
    const Mat3 before = state.velocity_gradient;
    Mat3& rate = state.velocity_gradient;
    rate = move.keep * before + move.push * push;
    const double strain = rate.norm() * move.time_step;
    if (strain > settings.largest_strain) rate *= settings.largest_strain / strain;
    return move.back * before + move.time_step * rate;
}

/// Moves four particles after four others.
class Mover {
  public:
    Mover(JamState& state, const Move& move, const PeriodicCell& halfway, double largest_move,
          const RelaxScratch& scratch)
        : particles_(state.particles),
          move_(move),
          to_fractional_(halfway.inverse()),
          top_speed_(largest_move * scratch.lists.smallest_diameter / move.time_step),
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
        const Columns4 step = {before.x * move_.back + after.x * move_.time_step,
                               before.y * move_.back + after.y * move_.time_step,
                               before.z * move_.back + after.z * move_.time_step, Double4{}};
        const Columns4 change = to_fractional_(step);
        Columns4 sphere = load_columns(particles_.spheres, quad);
        sphere.x += change.x;
        sphere.y += change.y;
        sphere.z += change.z;
        store_columns(sphere, quad, particles_.spheres);
        return dot(step, step);
    }

  private:
    Columns4 motion(const Columns4& before, const Columns4& load,
                    const QuadResponse& metric) const {
        const Mask4 touches = load.w > 0.0;
        const Double4 all = Double4{} + move_.keep;
        const Double4 keep = touches ? all : kept_by_loose_ones * all;
        const Columns4 push = metric(load);
        Columns4 after = {before.x * keep + push.x * move_.push,
                          before.y * keep + push.y * move_.push,
                          before.z * keep + push.z * move_.push, metric.mass};
        Double4 squared = dot(after, after);
        const Mask4 too_fast = squared > Double4{} + top_speed_ * top_speed_;
        if (bits_of(too_fast) != 0) scale(too_fast, squared, after);
        const Mask4 stops = ~touches & (squared < Double4{} + 1e-24 * top_speed_ * top_speed_);
        after.x = stops ? Double4{} : after.x;
        after.y = stops ? Double4{} : after.y;
        after.z = stops ? Double4{} : after.z;
        // Who is idle depends on the state alone, who is active on the tiles, too: what the idle
        // ones have must not.
        const Mask4 idle = ~touches & (dot(before, before) == Double4{});
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

/// Of the contacts that there are; zero without any.
double mean_overlap(const RelaxScratch& scratch, const Material& material, double smallest) {
    if (scratch.sums.contacts == 0) return 0.0;
    const double force = scratch.sums.force_magnitudes / static_cast<double>(scratch.sums.contacts);
    return overlap_of_force(material, force, smallest);
}

void renew_metric(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    const double smallest = scratch.lists.smallest_diameter;
    const double overlap = mean_overlap(scratch, settings.material, smallest);
    renew_stiffness(scratch.full, state.cell, settings.material, overlap, state.particles,
                    scratch.active, state.relax.stiffness);
    forget_metric(state.particles, scratch.metric);
    state.relax.renewal_age = 0;
}

void use_metric(const JamState& state, RelaxScratch& scratch) {
    set_metric(state.relax.stiffness, state.particles, scratch.active, scratch.metric);
}

/// After new tiles.
void find_active(const JamState& state, RelaxScratch& scratch) {
    find_active_particles(scratch.lists.tiles, state.particles, scratch.active);
}

void search(JamState& state, RelaxScratch& scratch) {
    const StageTimer timer(scratch.times, Stage::search);
    reduce_tilt(state);
    renew_lists(scratch.lists, state.cell, scratch.motion, state.particles);
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
    if (renewal == ListRenewal::search_needed) search(state, scratch);
    find_active(state, scratch);
    use_metric(state, scratch);
}

}  // namespace

void begin_relaxation(JamState& state, const RelaxSettings& settings, RelaxScratch& scratch) {
    if (state.list_reference.centers.empty()) {
        scratch.lists.hierarchy.group(state.particles);
        search(state, scratch);
    } else {
        restore_lists(scratch.lists, state.list_reference, state.cell, scratch.motion,
                      state.particles);
        scratch.full = full_list(scratch.lists.candidates);
    }
    find_active(state, scratch);
    forget_metric(state.particles, scratch.metric);
    if (state.relax.stiffness.empty()) {
        evaluate(state, settings, scratch);  // for the mean overlap
        renew_metric(state, settings, scratch);
    }
    use_metric(state, scratch);
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
    const double power = scratch.power + cell_force.cwiseProduct(state.velocity_gradient).sum();
    const double push_squared = scratch.push_squared + squared_norm(inertia, cell_push);
    const Move move = next_move(relax, power, push_squared, settings.largest_time_step);

    relax.speed_squared = speed_squared_after(relax.speed_squared, move, power, push_squared);

    const Mat3 strain = strain_of_step(state, settings, move, cell_push);
    const PeriodicCell halfway = strained_cell(state.cell, 0.5 * strain);
    state.cell = strained_cell(state.cell, strain);
    StepMotion moved{.displacement = 0.0, .strain = strain.norm()};
    {
        const StageTimer timer(scratch.times, Stage::integrate);
        moved.displacement = move_particles(
            scratch.active, Mover(state, move, halfway, settings.largest_move, scratch));
    }
    expect_more_of(moved, scratch.motion);
    keep_lists_valid(state, moved, scratch);
    evaluate(state, settings, scratch);
    ++state.step;
}

}  // namespace jam
