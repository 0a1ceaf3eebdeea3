// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/relax_step.h"

#include "contacts/elastic_laws.h"
#include "core/lanes.h"
#include "jamming/cell_motion.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

constexpr int steps_between_renewals = 50;

// FIRE's own numbers, as published, but for the shorter cut of the time step.
constexpr double first_mixing = 0.1;
constexpr double mixing_decay = 0.99;
constexpr double growth = 1.05;
constexpr double cut = 0.6;
constexpr int steps_before_growth = 10;

/// Share of its velocity that a particle keeps in a step while it touches nothing. It must hardly
/// lose any: what slides along pushes rattlers before it, and all that they lose it has to give.
constexpr double kept_by_loose_ones = 0.999;

double dot3(const Double4& a, const Double4& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Double4 times(const SymmetricBlock& m, const Double4& f) {
    return Double4{m.xx, m.xy, m.xz, 0.0} * f[0] + Double4{m.xy, m.yy, m.yz, 0.0} * f[1] +
           Double4{m.xz, m.yz, m.zz, 0.0} * f[2];
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
        DescentSums sums;
        for (const Index particle : scratch.active.of_block(block)) {
            const auto i = static_cast<std::size_t>(particle);
            const Double4 load = load4(particles.loads[i]);
            const double squared = dot3(load, load);
            if (squared == 0.0) continue;
            sums.power += dot3(load, load4(particles.motions[i]));
            sums.push_squared += dot3(load, times(scratch.metric.particles[i].inverse, load));
            sums.net_force += std::sqrt(squared);
        }
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

struct Moved {
    double displacement_squared = 0.0;  ///< largest since the tiles were made
    double largest_speed_squared = 0.0;

    Moved& operator+=(const Moved& other) {
        displacement_squared = std::max(displacement_squared, other.displacement_squared);
        largest_speed_squared = std::max(largest_speed_squared, other.largest_speed_squared);
        return *this;
    }
};

/// Moves one particle after another.
class Mover {
  public:
    Mover(JamState& state, const Move& move, const PeriodicCell& halfway, double largest_move,
          const RelaxScratch& scratch)
        : particles_(state.particles),
          move_(move),
          to_fractional_(halfway.inverse()),
          to_cartesian_(state.cell.matrix()),
          top_speed_(largest_move * scratch.lists.smallest_diameter / move.time_step),
          scratch_(scratch) {}

    void operator()(std::size_t i, Moved& moved) const {
        const Double4 load = load4(particles_.loads[i]);
        const Double4 before = load4(particles_.motions[i]);
        const bool touches = load[3] > 0.0;
        if (!touches && dot3(before, before) == 0.0) return;
        const Double4 after = velocity(before, load, touches, scratch_.metric.particles[i], moved);
        store4(after, particles_.motions[i]);
        const Double4 step = before * move_.back + after * move_.time_step;
        const Double4 sphere = load4(particles_.spheres[i]) + to_fractional_(step);
        store4(sphere, particles_.spheres[i]);
        const Vec3& origin = scratch_.lists.inner.centers[i];
        const Double4 away = to_cartesian_(sphere - Double4{origin[0], origin[1], origin[2], 0.0});
        moved.displacement_squared = std::max(moved.displacement_squared, dot3(away, away));
    }

  private:
    Double4 velocity(const Double4& before, const Double4& load, bool touches,
                     const BlockResponse& metric, Moved& moved) const {
        const double keep = touches ? move_.keep : kept_by_loose_ones * move_.keep;
        Double4 after = before * keep + times(metric.inverse, load) * move_.push;
        double squared = dot3(after, after);
        if (squared > top_speed_ * top_speed_) {
            after *= top_speed_ / std::sqrt(squared);
            squared = top_speed_ * top_speed_;
        }
        if (!touches && squared < 1e-24 * top_speed_ * top_speed_) after = Double4{};
        after[3] = metric.mass;
        moved.largest_speed_squared = std::max(moved.largest_speed_squared, squared);
        return after;
    }

    Particles& particles_;
    Move move_;
    UpperMap to_fractional_;
    UpperMap to_cartesian_;
    double top_speed_;
    const RelaxScratch& scratch_;
};

Moved move_particles(const ActiveParticles& active, const Mover& mover) {
    return sum_active(active, Moved{}, [&](Count block) {
        Moved moved;
        for (const Index i : active.of_block(block)) mover(static_cast<std::size_t>(i), moved);
        return moved;
    });
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
}

void keep_lists_valid(JamState& state, RelaxScratch& scratch, double displacement) {
    ListRenewal renewal;
    {
        const StageTimer timer(scratch.times, Stage::refilter);
        renewal = keep_tiles_valid(scratch.lists, state.cell, scratch.motion, displacement,
                                   state.particles);
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
    scratch.metric.particles.assign(state.particles.spheres.size(), {});
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
    Moved moved;
    {
        const StageTimer timer(scratch.times, Stage::integrate);
        moved = move_particles(scratch.active,
                               Mover(state, move, halfway, settings.largest_move, scratch));
    }
    scratch.motion = {std::sqrt(moved.largest_speed_squared) * move.time_step, strain.norm()};
    keep_lists_valid(state, scratch, std::sqrt(moved.displacement_squared));
    evaluate(state, settings, scratch);
    ++state.step;
}

}  // namespace jam
