// SPDX-License-Identifier: BSD-3-Clause
// The input scripts of a handoff as text.
#pragma once

#include "jamming/jam_state.h"
#include "jamming/nph_step.h"
#include "jamming/scene.h"

#include <string>

namespace jam {

/// What the scripts are written from.
struct LammpsTask {
    const Scene& scene;
    const JamState& start;
    NphSettings settings;  ///< as nph_settings gives them
};

/// system.in: reads start.data, or the restart file that the variable `from` names.
std::string lammps_system_script(const LammpsTask& task);

/// run.in: includes system.in.
std::string lammps_run_script(const LammpsTask& task);

/// job.slurm.
std::string slurm_script(const LammpsTask& task);

}  // namespace jam
