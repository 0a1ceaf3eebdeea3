// SPDX-License-Identifier: BSD-3-Clause
#include "handoff/handoff.h"

#include "core/check.h"
#include "core/whole_file.h"
#include "handoff/lammps_script.h"
#include "jamming/nph_step.h"
#include "jamming/scene_file.h"
#include "packing/lammps_data.h"
#include "packing/packing_io.h"

#include <array>
#include <string_view>
#include <system_error>

namespace jam {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> files = {"start.data", "system.in", "run.in", "job.slurm",
                                                   "back.toml"};

void require_free(const fs::path& folder) {
    std::error_code none;
    for (const std::string_view file : files)
        require(!fs::exists(folder / file, none),
                "{}: holds a handoff already ({}); remove it, or give another folder",
                folder.string(), file);
}

/// Masses in LAMMPS follow from densities; each sphere has one of its own unless all have the
/// material's, which none stands for.
std::vector<double> densities(const JamState& state, Masses masses) {
    if (masses == Masses::true_mass) return {};
    std::vector<double> densities(state.particles.spheres.size());
    for (std::size_t i = 0; i < densities.size(); ++i)
        densities[state.particles.ids[i]] =
            state.particles.motions[i].mass / sphere_volume(state.particles.spheres[i].diameter);
    return densities;
}

/// The scene that goes on from what LAMMPS leaves.
Scene scene_back(Scene scene) {
    scene.start.packing = "final.dump";
    scene.run.output.clear();
    return scene;
}

}  // namespace

void write_handoff(const Scene& scene, const fs::path& folder) {
    require_free(folder);
    const JamState start = start_state(scene);
    const LammpsTask task{scene, start, nph_settings(scene, start)};
    make_folder(folder, "give another");
    write_lammps_data(to_packing(start, scene), folder / "start.data",
                      densities(start, scene.protocol.masses));
    write_whole_file(folder / "system.in", lammps_system_script(task));
    write_whole_file(folder / "run.in", lammps_run_script(task));
    write_whole_file(folder / "job.slurm", slurm_script(task));
    write_whole_file(folder / "back.toml", scene_text(scene_back(scene)));
}

}  // namespace jam
