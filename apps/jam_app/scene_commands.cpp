// SPDX-License-Identifier: BSD-3-Clause
// The commands that only read: new, keys, check.
#include "jam_app/commands.h"
#include "jamming/scene_file.h"
#include "jamming/scene_forecast.h"
#include "shared/program.h"

#include <fmt/format.h>

namespace jam::apps {

int new_scene(const std::string& sizes_kind) {
    fmt::print("{}", scene_template(sizes_kind));
    return exit_good;
}

int list_keys() {
    fmt::print("{}", scene_reference());
    return exit_good;
}

static void print_line(const char* name, const std::string& text) {
    fmt::print("  {:<18}{}\n", name, text);
}

static void print_collections(const SizeCollections& collections) {
    double above = 0.0;
    for (int c = 0; c < collections.count(); ++c) {
        const auto at = static_cast<std::size_t>(c);
        print_line(c == 0 ? "collections" : "",
                   fmt::format("{} particles above {:.4g} and up to {:.4g}",
                               collections.begin[at + 1] - collections.begin[at], above,
                               collections.upper[at]));
        above = collections.upper[at];
    }
}

int check_scene(const SceneOptions& options) {
    const Scene scene = read_scene(options.scene, options.overrides);
    const SceneForecast told = forecast(scene);
    fmt::print("{}\n", options.scene.string());
    print_line("particles", fmt::format("{}", told.particle_count));
    print_line("diameters",
               fmt::format("{:.4g} to {:.4g}", told.smallest_diameter, told.largest_diameter));
    print_line("volume fraction",
               fmt::format("{:.4g} at the start, {:.3f} +-0.01 when jammed (rod model)",
                           told.start_volume_fraction, told.jammed_volume_fraction));
    print_line("cell", fmt::format("{:.4g} wide at the start, {:.4g} when jammed, which is {:.3g} "
                                   "of the largest diameters",
                                   told.start_cell_edge, told.jammed_cell_edge,
                                   told.jammed_cell_edge / told.largest_diameter));
    print_collections(told.collections);
    return exit_good;
}

}  // namespace jam::apps
