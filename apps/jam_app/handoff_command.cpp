// SPDX-License-Identifier: BSD-3-Clause
// jam_app handoff: a scene, or a packing that is to be jammed further, for LAMMPS.
#include "handoff/handoff.h"
#include "jam_app/commands.h"
#include "jamming/rejam.h"
#include "jamming/scene_file.h"
#include "shared/program.h"
#include "shared/shell_word.h"

#include <fmt/format.h>

namespace jam::apps {

static Scene scene_of(const SceneOptions& options) {
    return options.scene.extension() == ".toml"
               ? read_scene(options.scene, options.overrides)
               : scene_from_packing(options.scene, options.overrides);
}

int hand_off(const HandoffOptions& options) {
    write_handoff(scene_of(options.scene), options.folder);
    const std::string folder = shell_word(options.folder.string());
    fmt::print("{}: start.data, system.in, run.in, job.slurm, back.toml\n",
               options.folder.string());
    fmt::print("jam it there:  cd {} && mpirun -np 2 lmp -in run.in\n", folder);
    fmt::print("or on Slurm:   cd {} && sbatch job.slurm\n", folder);
    fmt::print("take it back:  jam_app run {} --out {}\n",
               shell_word((options.folder / "back.toml").string()),
               shell_word((options.folder / "back").string()));
    return exit_good;
}

}  // namespace jam::apps
