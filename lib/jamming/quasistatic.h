// SPDX-License-Identifier: BSD-3-Clause
// The quasi-static protocol: compaction by inertia at a pressure high enough to be quick, then
// relaxation of the enthalpy under a pressure that descends, to a minimum at the applied one.
//
// The jammed state does not remember inertia, so none is needed to find it. What is near balance
// follows a falling pressure and keeps its network; what loses it is slow to find another. So the
// pressure falls the faster the nearer to balance forces are, waits where they are not, and where
// it is low rises until they are. At the foot Newton's method ends what the relaxation has begun.
#pragma once

#include "jamming/newton_relaxation.h"
#include "jamming/nph_step.h"
#include "jamming/relax_step.h"

#include <optional>

namespace jam {

struct QuasistaticSettings {
    NphSettings compaction;  ///< masses by diameter, whatever the scene's
    RelaxSettings relax;     ///< at the applied pressure
    NewtonSettings newton;
    DescentSettings descent;
    StopSettings stop;
    double first_pressure = 0.0;    ///< mean pressure from which the descent begins
    double climbed_pressure = 0.0;  ///< from where it begins anew
    double applied_pressure = 0.0;  ///< mean pressure at its foot
    bool newton_serves = false;     ///< isotropic pressure, cell free in all components
};

/// Where the descent begins unless a scene says so: at the pressure that overlaps equal spheres by
/// 1e-3 of the smallest diameter, or less where sizes are wide, so that small spheres between large
/// ones are not squeezed flat: at 5 D_min / D_V of it, D_V the mean diameter by volume.
double automatic_compaction_pressure(const Material& material, std::span<const double> diameters);

/// The descent never begins below the applied pressure.
QuasistaticSettings quasistatic_settings(const Scene& scene, const JamState& state);

/// A run by this protocol, one step at a time. All that decides how it goes on is in the state.
class QuasistaticRun {
  public:
    /// Both must outlive the run.
    QuasistaticRun(const Scene& scene, JamState& state);

    /// Lists and forces, for a new state or one from a checkpoint.
    void begin();
    /// One step: of compaction or of relaxation, and where Newton's method comes into balance all
    /// of it (as many steps as it took factorizations).
    void advance();
    /// As far as forces and stress tell (QuasistaticState); the verdict decides.
    bool at_rest() const { return state_.quasistatic.at_rest; }

    const ContactSums& sums() const;
    const StepMotion& motion() const;
    double time_step() const { return settings_.compaction.time_step; }
    StageTimes times() const;

  private:
    bool compacting() const;
    bool at_foot() const;
    void begin_descent();
    void begin_descent_from(double pressure);
    /// Mean pressure; the applied one if it is less.
    void apply(double pressure);
    void relax();
    /// By a share of the fastest descent; up where it is negative.
    void descend(double share);
    /// Up to where it may rise.
    double highest_pressure() const;
    /// Cundall parameter over its limit; not a number without contacts.
    double cundall_in_limits() const;
    bool may_rise() const;
    /// Of buckling, in the metric's units of time.
    double slowest_turn() const;
    /// Of the pressure, of itself a step; half as fast each time that the descent begins anew.
    double fastest_descent() const;
    void finish();
    void leap_from_saddle();
    void look_whether_whole();
    void climb();
    /// Whether it came into balance; says in the state when to try again.
    bool try_newton();
    Mat3 pressure_now() const;

    const Scene& scene_;
    JamState& state_;
    QuasistaticSettings settings_;
    ProtocolSettings protocol_;
    ListSettings lists_;
    std::vector<double> diameters_;
    std::optional<NphScratch> compaction_;
    std::optional<RelaxScratch> relaxation_;
};

}  // namespace jam
