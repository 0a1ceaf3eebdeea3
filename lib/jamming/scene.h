// SPDX-License-Identifier: BSD-3-Clause
// What a run is asked to do: plain settings with defaults, as a scene file says them.
//
// docs/scene.md lists the same settings by the keys of the file; scene_file.h reads and writes
// them.
#pragma once

#include "core/types.h"
#include "neighbors/list_settings.h"
#include "particles/material.h"
#include "sizes/draw_diameters.h"
#include "sizes/size_distribution.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace jam {

/// Which spheres are packed. Not used when a run starts from a saved packing.
struct SizesSettings {
    SizeDistribution distribution = PowerLaw{};
    DrawMethod draw = DrawMethod::stratified;
    std::optional<Count> count;  ///< nothing: particle_count(distribution)
    std::filesystem::path file;  ///< that a table was read from
};

/// How a run begins: particles placed at random without overlap, or a saved packing.
struct StartSettings {
    double volume_fraction = 0.3;   ///< of the random start; not used with a packing
    std::filesystem::path packing;  ///< a saved packing to start from; empty: a random start
};

/// The way from the start to the jammed state.
enum class ProtocolKind : std::uint8_t {
    quasistatic,  ///< compaction, then relaxation at pressures that fall to the applied one
    nph,          ///< constant pressure and enthalpy, inertial (Monti et al., Methods)
};

/// Which edges and tilts of the cell may change.
enum class FreeCell : std::uint8_t {
    all,         ///< six: three edges, three tilts
    orthogonal,  ///< three edges, no tilt
    isotropic,   ///< one: the volume, at fixed shape
};

/// Inertia of the particles. The mechanical equilibria do not depend on it; the way there does.
enum class Masses : std::uint8_t {
    true_mass,  ///< density times volume, as the paper
    diameter,   ///< proportional to the diameter
    equal,      ///< all the same
};

/// Points on the measured front of speed against accuracy (docs/accuracy.md).
enum class Accuracy : std::uint8_t {
    fast,      ///< phi and the rattlers; not isostatic at low pressure
    standard,  ///< a stable, isostatic packing
    paper,     ///< the same, after a slower descent
};

/// Of the quasi-static protocol: what may be traded against accuracy.
struct DescentSettings {
    /// From where the pressure descends; nothing: chosen from law and sizes (quasistatic.h).
    std::optional<double> compaction_pressure;
    Count compaction_steps = 6'000;
    double rate = 1e-4;     ///< fastest fall of the pressure, of itself a step; of many contacts
    double cundall = 1e-3;  ///< at which the pressure waits, where overlaps are 1e-4 or more
};

struct ProtocolSettings {
    ProtocolKind kind = ProtocolKind::quasistatic;
    Accuracy accuracy = Accuracy::standard;   ///< see take_defaults_of
    Mat3 pressure = Mat3::Identity() * 1e-6;  ///< applied; symmetric; stiffness/length (hooke)
    FreeCell free_cell = FreeCell::all;
    /// In tau = sqrt(M_min / k), M_min the true mass of the smallest particle; nothing: chosen from
    /// the stiffest particle.
    std::optional<double> time_step;
    Masses masses = Masses::true_mass;
    double cell_inertia = 1.0;  ///< factor on the inertia chosen from N, k and D
    double cell_damping = 1.0;  ///< factor on the damping chosen with it
    DescentSettings descent;
};

/// When a run is converged (all of the tolerances hold at once), and when it stops without being
/// so.
struct StopSettings {
    double pressure = 1e-4;  ///< largest |P_int - P_a| of the six components, over the mean of P_a
    double cundall = 1e-6;   ///< Cundall parameter C
    bool stability = true;   ///< quasistatic: no contact missing to isostaticity, no unstable mode
    double kinetic_energy = 1e-13;         ///< a particle
    double volume_fraction_change = 1e-6;  ///< largest minus smallest phi within the window
    double coordination_change = 1e-3;     ///< largest minus smallest Z within the window
    Count window = 10'000;                 ///< steps
    Count max_steps = 100'000'000;  ///< since the start of the run, earlier sittings included
    double max_time = 0.0;          ///< wall time of one sitting, seconds; 0: no limit
};

struct RunSettings {
    std::uint64_t seed = 1;
    int threads = 0;                     ///< 0: all that the machine has
    Count record_interval = 1'000;       ///< steps
    Count checkpoint_interval = 50'000;  ///< steps
    std::filesystem::path output;        ///< folder; empty: runs/NAME, after the scene file
    ListSettings lists;
};

struct Scene {
    SizesSettings sizes;
    Material contact;
    StartSettings start;
    ProtocolSettings protocol;
    StopSettings stop;
    RunSettings run;
};

/// Sets the descent and the criteria of rest to what belongs to scene.protocol.accuracy.
void take_defaults_of_accuracy(Scene& scene);

/// Number of particles that the settings ask for. Throws InputError as particle_count.
Count particle_count(const SizesSettings& sizes);

/// The diameters of the scene, by particle id.
std::vector<double> draw_diameters(const Scene& scene);

}  // namespace jam
