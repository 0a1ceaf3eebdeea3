// SPDX-License-Identifier: BSD-3-Clause
// jam_app rejam: a saved packing converges again, with or without its rattlers.
#include "analysis/packing_statistics.h"
#include "core/whole_file.h"
#include "jam_app/commands.h"
#include "jam_app/run_folder.h"
#include "jamming/rejam.h"
#include "jamming/scene_file.h"
#include "jamming/scene_keys.h"
#include "packing/packing_file.h"
#include "packing/packing_io.h"
#include "shared/program.h"

#include <fmt/format.h>

namespace jam::apps {

namespace {

PackingStatistics statistics_of(const Packing& packing) {
    return packing_statistics(packing, find_force_network(packing));
}

void print_change(const PackingStatistics& before, const PackingStatistics& after) {
    fmt::print("\n{:<24}{:>14}{:>14}{:>14}\n", "", "before", "after", "change");
    const auto line = [&](const char* name, double was, double is) {
        fmt::print("{:<24}{:>14.8g}{:>14.8g}{:>+14.3g}\n", name, was, is, is - was);
    };
    line("particles", static_cast<double>(before.particle_count),
         static_cast<double>(after.particle_count));
    line("volume_fraction", before.volume_fraction, after.volume_fraction);
    line("volume_fraction_nr", before.volume_fraction_nr, after.volume_fraction_nr);
    line("coordination_nr", before.coordination_nr, after.coordination_nr);
    line("rattler_fraction", before.rattler_fraction, after.rattler_fraction);
}

/// The folder's own scene and start, so that the run is one like any other and may be gone on with.
std::filesystem::path write_start(const Packing& packing, Scene scene, const RunFolder& folder) {
    make_folder(folder.path(), "give another by --out");
    save_packing(packing, folder.path() / "start.h5");
    scene.start.packing = "start.h5";
    std::filesystem::path file = folder.path() / "scene.toml";
    write_whole_file(file, scene_text(scene));
    return file;
}

}  // namespace

int rejam_packing(const RejamOptions& options) {
    const RunFolder folder(options.folder);
    folder.require_free();
    const Packing before = read_packing(options.packing);
    Scene scene = scene_from_packing(before, options.packing, options.overrides);
    scene.protocol.kind = ProtocolKind::quasistatic;
    begin_at_applied_pressure(scene);
    const Packing start = options.without_rattlers ? without_rattlers(before) : before;

    RunOptions run;
    run.scene.scene = write_start(start, std::move(scene), folder);
    run.scene.overrides = {"run.output=" + toml_text(options.folder.string())};
    run.command_line = options.command_line;
    const int status = run_scene(run);
    print_change(statistics_of(before), statistics_of(load_packing(folder.packing())));
    return status;
}

}  // namespace jam::apps
