// SPDX-License-Identifier: BSD-3-Clause
#include "handoff/lammps_script.h"

#include "core/version.h"
#include "neighbors/verlet_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace jam {

namespace {

// --- system.in ----------------------------------------------------------------------------------

std::string pair_commands(const Material& material) {
    const auto [law, k, gamma, density] = material;
    if (law == ContactLaw::hooke)
        return fmt::format(
            "# F = {0} overlap - M_eff {1} v_n, never attractive; no friction\n"
            "pair_style      gran/hooke {0} NULL {1} 0.0 0.0 0 limit_damping\n"
            "pair_coeff      * *\n",
            k, gamma);
    return fmt::format(
        "# F = {0} sqrt(R_eff overlap) overlap - M_eff {1} v_n, never attractive; no friction\n"
        "pair_style      granular\n"
        "pair_coeff      * * hertz {0} {1} tangential linear_nohistory 0.0 0.0 &\n"
        "                damping mass_velocity limit_damping\n",
        k, gamma);
}

/// A neighbor list takes pairs up to the sum of radii plus this.
constexpr double skin_in_smallest_diameters = 0.1;

std::string neighbor_commands(const std::vector<double>& diameters, const ListSettings& lists) {
    const double skin = skin_in_smallest_diameters * *std::ranges::min_element(diameters);
    const std::vector<double> upper = list_collections(diameters, lists).upper;
    const std::string_view memory = "page 1000000 one 50000";
    if (upper.size() == 1)
        return fmt::format(
            "neighbor        {} bin\n"
            "neigh_modify    every 1 delay 0 check yes {}\n"
            "comm_modify     mode single vel yes\n",
            skin, memory);
    return fmt::format(
        "# One grid for each interval of diameters, of which these are the upper bounds.\n"
        "neighbor        {} multi\n"
        "neigh_modify    every 1 delay 0 check yes {} &\n"
        "                collection/interval {} {}\n"
        "comm_modify     mode multi vel yes reduce/multi\n",
        skin, memory, upper.size(), fmt::join(upper, " "));
}

bool can_tilt(const LammpsTask& task) {
    return task.settings.free_cell == FreeCell::all;
}

/// LAMMPS makes a tilt free only of a cell that it knows to be triclinic.
std::string_view tilt_command(const LammpsTask& task) {
    return can_tilt(task) && task.start.cell.is_orthogonal() ? "change_box      all triclinic\n"
                                                             : "";
}

// --- run.in -------------------------------------------------------------------------------------

/// A pressure of the barostat: name, target at the start and end of a run, period.
std::string target(std::string_view name, double pressure) {
    return fmt::format(" {} {} {} ${{period}}", name, pressure, pressure);
}

std::string targets(const NphSettings& settings) {
    const Mat3& p = settings.applied_pressure;
    const std::string edges = target("x", p(0, 0)) + target("y", p(1, 1)) + target("z", p(2, 2));
    switch (settings.free_cell) {
        case FreeCell::isotropic:
            return target("iso", p(0, 0));
        case FreeCell::orthogonal:
            return edges + " couple none";
        case FreeCell::all:
            break;
    }
    return edges + " &\n               " + target("xy", p(0, 1)) + target("yz", p(1, 2)) +
           target("xz", p(0, 2));
}

/// The barostat with our inertia W and damping Gamma. LAMMPS has W = (N + 1) T period^2 and damps
/// at the rate 2 drag / period; its T is no temperature here, and set to 1.
std::string barostat(const LammpsTask& task) {
    const double spheres = static_cast<double>(task.start.particles.size());
    const double period = std::sqrt(task.settings.cell_inertia / (spheres + 1.0));
    const double drag = 0.5 * task.settings.cell_damping * period;
    // A stress that is not the same in all directions is meant in the cell as it is now.
    const Mat3& p = task.settings.applied_pressure;
    const bool isotropic = p == Mat3(Mat3::Identity() * p(0, 0));
    return fmt::format(
        "# Constant pressure and enthalpy. ptemp sets the inertia of the cell, together with "
        "period,\n"
        "# and no temperature; pchain 0: nothing warms the cell's motion; mtk no: no thermal "
        "terms.\n"
        "variable        period equal {}\n"
        "variable        drag equal {}\n"
        "fix             barostat all nph/sphere{} &\n"
        "                ptemp 1.0 drag ${{drag}} pchain 0 mtk no{}\n",
        period, drag, targets(task.settings), isotropic ? "" : " nreset 1");
}

/// True when every component that the cell answers to is within the tolerance.
std::string pressure_criterion(const NphSettings& settings, double tolerance) {
    const Mat3& p = settings.applied_pressure;
    const double allowed = tolerance * p.trace() / 3.0;
    std::vector<std::string> terms;
    const auto add = [&](std::string_view keyword, double applied) {
        terms.push_back(fmt::format("(abs({}-({}))<={})", keyword, applied, allowed));
    };
    if (settings.free_cell == FreeCell::isotropic) {
        add("press", p(0, 0));
        return terms.front();
    }
    add("pxx", p(0, 0));
    add("pyy", p(1, 1));
    add("pzz", p(2, 2));
    if (settings.free_cell == FreeCell::all) {
        add("pxy", p(0, 1));
        add("pyz", p(1, 2));
        add("pxz", p(0, 2));
    }
    return fmt::format("{}", fmt::join(terms, "&&"));
}

std::string measuring_commands(const LammpsTask& task) {
    double solid = 0.0;
    for (const double diameter : diameters_by_id(task.start.particles))
        solid += sphere_volume(diameter);
    return fmt::format(
        R"in(# What is recorded: volume fraction, contacts a particle, Cundall parameter, kinetic energy a particle.
variable        phi equal {}/vol
compute         contacts all contact/atom
compute         contact_sum all reduce sum c_contacts
variable        z equal c_contact_sum/atoms
variable        net atom sqrt(fx^2+fy^2+fz^2)
compute         net_sum all reduce sum v_net
compute         force all pair/local force cutoff radius
compute         force_sum all reduce sum c_force
variable        cundall equal c_net_sum/(c_force_sum+1e-300)
compute         energy all ke
variable        ekin equal c_energy/atoms
)in",
        solid);
}

/// As many steps as `steps`, rounded up to whole records.
Count whole_records(Count steps, Count record) {
    return (steps + record - 1) / record * record;
}

std::string recording_commands(const Scene& scene) {
    return fmt::format(R"in(thermo          {record}
thermo_style    custom step v_phi v_z press pxx pyy pzz pxy pyz pxz v_cundall v_ekin
thermo_modify   format float %.8g norm no
# Two restart files in turn, so that one is always whole, and the last three states as dumps.
restart         {checkpoint} restart.1 restart.2
dump            states all custom {checkpoint} state.*.dump id type diameter x y z vx vy vz
dump_modify     states format float %.17g maxfiles 3
)in",
                       fmt::arg("record", scene.run.record_interval),
                       fmt::arg("checkpoint", scene.run.checkpoint_interval));
}

/// Steps are done in windows, for only between two runs can a script look back.
std::string loop_commands(const LammpsTask& task) {
    const StopSettings& stop = task.scene.stop;
    const Count record = task.scene.run.record_interval;
    return fmt::format(
        R"in(# A window of steps, then the criteria; "halt" ends the last window when the wall time is over.
variable        seconds index {seconds}
fix             limit all halt {record} tlimit > ${{seconds}} error continue message yes
label           window
variable        before equal $(step)
fix             history all vector {record} v_phi v_z
run             {window} post no
variable        dphi equal $(max(f_history[1])-min(f_history[1]))
variable        dz equal $(max(f_history[2])-min(f_history[2]))
unfix           history
variable        whole equal $(step-v_before=={window})
variable        pressure_holds equal "{pressure}"
variable        others_hold equal "(v_cundall<={cundall})&&(v_ekin<={ekin})&&(v_dphi<={dphi})&&(v_dz<={dz})"
variable        converged equal $(v_whole&&v_pressure_holds&&v_others_hold)
print           "step $(step): phi $(v_phi:%.8f) +- ${{dphi}}, Z $(v_z:%.6f) +- ${{dz}}, converged: ${{converged}}"
if              "${{converged}} || !${{whole}} || ($(step) >= {max_steps})" then "jump SELF done"
jump            SELF window
)in",
        fmt::arg("seconds", stop.max_time > 0.0 ? stop.max_time : 1e9), fmt::arg("record", record),
        fmt::arg("window", whole_records(stop.window, record)),
        fmt::arg("pressure", pressure_criterion(task.settings, stop.pressure)),
        fmt::arg("cundall", stop.cundall), fmt::arg("ekin", stop.kinetic_energy),
        fmt::arg("dphi", stop.volume_fraction_change), fmt::arg("dz", stop.coordination_change),
        fmt::arg("max_steps", stop.max_steps));
}

/// As many ranks as give each enough spheres to be worth its messages.
Count ranks_for(Count spheres) {
    constexpr Count spheres_a_rank = 50'000;
    return std::max<Count>(1, (spheres + spheres_a_rank / 2) / spheres_a_rank);
}

}  // namespace

std::string lammps_system_script(const LammpsTask& task) {
    const std::vector<double> diameters = diameters_by_id(task.start.particles);
    return fmt::format(
        R"in(# {} spheres, their contacts and their neighbor lists; written by Widejam {}.
# Units are the scene's: its diameters, stiffness and density.
units           lj
atom_style      sphere
boundary        p p p
newton          on
box             tilt large
{}
# Begin with start.data, or go on:  lmp -in run.in -var read "read_restart restart.1"
variable        read index "read_data start.data"
${{read}}
{}
{}
timestep        {}
)in",
        diameters.size(), version, neighbor_commands(diameters, task.scene.run.lists),
        tilt_command(task), pair_commands(task.settings.material), task.settings.time_step);
}

std::string lammps_run_script(const LammpsTask& task) {
    return fmt::format(
        R"in(# Jams the spheres of system.in as Widejam {} would; ends with final.dump.
#     mpirun -np 4 lmp -in run.in                                       # begin
#     mpirun -np 4 lmp -in run.in -var read "read_restart restart.1"    # go on (or restart.2)
# More about it in docs/handoff.md of Widejam.
include         system.in

{}
{}
{}
{}
label           done
unfix           limit
undump          states
# Forces and pressure once more, of exactly the state that is saved.
run             0 post no
write_restart   restart.final
write_dump      all custom final.dump id type diameter x y z vx vy vz modify format float %.17g
)in",
        version, barostat(task), measuring_commands(task), recording_commands(task.scene),
        loop_commands(task));
}

std::string slurm_script(const LammpsTask& task) {
    return fmt::format(R"in(#!/bin/bash
# Begins the run in this folder, or goes on from its latest restart file: submit it again as often as needed.
#SBATCH --job-name=widejam
#SBATCH --ntasks={}
#SBATCH --cpus-per-task=1
#SBATCH --time=24:00:00
set -euo pipefail
cd "${{SLURM_SUBMIT_DIR:-.}}"
latest=$(ls -t restart.1 restart.2 2>/dev/null | head -n 1 || true)
# A quarter of an hour before the job's end, so that the state is saved; adapt both together.
${{LAUNCH:-srun}} ${{LAMMPS:-lmp}} -in run.in -log "log.${{SLURM_JOB_ID:-$$}}" \
    -var seconds "${{SECONDS_LEFT:-85500}}" ${{latest:+-var read "read_restart $latest"}}
)in",
                       ranks_for(task.start.particles.size()));
}

}  // namespace jam
