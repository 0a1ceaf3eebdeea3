// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/rejam.h"

#include "analysis/force_network.h"
#include "core/check.h"
#include "jamming/scene_file.h"
#include "packing/packing_io.h"

#include <algorithm>

namespace jam {

Scene scene_from_packing(const std::filesystem::path& path,
                         std::span<const std::string> overrides) {
    return scene_from_packing(read_packing(path), path, overrides);
}

Scene scene_from_packing(const Packing& packing, const std::filesystem::path& path,
                         std::span<const std::string> overrides) {
    Scene scene;
    if (packing.provenance.scene.empty()) {
        scene.contact = packing.material;
        if (!packing.applied_pressure.isZero(0.0))
            scene.protocol.pressure = packing.applied_pressure;
    } else {
        scene = parse_scene(packing.provenance.scene, path);
    }
    scene.start.packing = std::filesystem::absolute(path);
    scene.run.output.clear();
    return parse_scene(scene_text(scene), path, overrides);
}

Packing without_rattlers(const Packing& packing) {
    const ForceNetwork network = find_force_network(packing);
    require(network.rattlers.backbone_count() > 0,
            "the packing is not jammed: all {} particles are rattlers; it must have a backbone",
            packing.size());
    Packing backbone = packing;
    backbone.positions.clear();
    backbone.diameters.clear();
    backbone.velocities.clear();
    backbone.ids.clear();
    for (std::size_t i = 0; i < packing.positions.size(); ++i) {
        if (network.rattlers.is_rattler[i]) continue;
        backbone.positions.push_back(packing.positions[i]);
        backbone.diameters.push_back(packing.diameters[i]);
        backbone.ids.push_back(packing.ids[i]);
    }
    return backbone;
}

void begin_at_applied_pressure(Scene& scene) {
    scene.protocol.descent.compaction_pressure = scene.protocol.pressure.trace() / 3.0;
    scene.protocol.descent.compaction_steps = 0;
}

}  // namespace jam
