// SPDX-License-Identifier: BSD-3-Clause
// The state of a run: everything that decides how it goes on, and nothing else.
#pragma once

#include "cell/periodic_cell.h"
#include "jamming/relaxation_metric.h"
#include "jamming/scene.h"
#include "neighbors/list_validity.h"
#include "packing/packing.h"
#include "particles/particles.h"

#include <deque>

namespace jam {

/// What the criteria of stationarity look back on.
struct Sample {
    Count step;
    double volume_fraction;
    double coordination;
};

/// What a relaxation (relax_step.h) remembers from step to step; its velocities stand with the
/// particles and the cell.
struct RelaxState {
    int renewal_age = 0;  ///< steps since the stiffness was renewed
    ContactStiffness stiffness;
};

/// Where particles were some steps ago, with which a run at a saddle compares (saddle_leap.h).
struct LeapReference {
    double cundall = 0.0;       ///< then
    std::vector<Vec3> centers;  ///< by id, fractional; empty: there is none
};

/// Where a quasi-static run stands (quasistatic.h).
struct QuasistaticState {
    enum class Stage : std::uint8_t { compaction, relaxation };
    Stage stage = Stage::compaction;
    double pressure = 0.0;         ///< mean pressure applied just now; 0: the run has not begun
    double lowest_pressure = 0.0;  ///< of this descent
    Count foot_begin = 0;          ///< step at which the descent ended
    Count next_trial = 0;          ///< step from which Newton's method is tried again
    double trial_cundall = 0.0;    ///< of its last trial there; 0: there is none to better
    Count last_whole = 0;  ///< step of the last look at the foot that found it whole and in motion
    int retreats = 0;      ///< times that the descent was begun again, slower
    LeapReference leap;    ///< empty wherever the run is at no saddle
    bool at_rest = false;  ///< at the foot, as far as forces and stress tell, or found converged
};

struct JamState {
    PeriodicCell cell;
    Mat3 velocity_gradient = Mat3::Zero();  ///< L of the cell's flow, upper triangular, 1/time
    Particles particles;
    Mat3 pressure = Mat3::Zero();  ///< internal, dynamic, of the last step
    RelaxState relax;
    QuasistaticState quasistatic;
    Count step = 0;
    double time = 0.0;
    double wall_seconds = 0.0;   ///< of all sittings
    std::deque<Sample> samples;  ///< within stop.window, oldest first
    /// For what the candidate list was made; with it a run that goes on has the same list in the
    /// same order, and so the same bits. Empty before the first list.
    ListReference list_reference;
    std::vector<std::int64_t> original_ids;  ///< by id; empty where they are 0..N-1
};

/// The state a scene begins with: particles drawn and placed at random, or those of a saved
/// packing; at rest. Throws InputError if the packing's cell is narrower than its largest sphere,
/// or if two of its spheres have one center.
JamState start_state(const Scene& scene);

/// Inertial masses by diameter, in units where the scene's density and stiffness stand.
double inertial_mass(double diameter, double smallest_diameter, Masses masses, double density);

/// tau = sqrt(M_min / k), in which a scene gives its time step; M_min is the true mass of the
/// smallest particle.
double unit_of_time(const Material& material, double smallest_diameter);

/// Gives every particle its inertial mass; there must be at least one.
void set_masses(Particles& particles, Masses masses, double density);

/// Diameters in the order of the ids.
std::vector<double> diameters_by_id(const Particles& particles);

/// The state as a packing, particles in the order of their ids, positions within the cell.
Packing to_packing(const JamState& state, const Scene& scene);

}  // namespace jam
