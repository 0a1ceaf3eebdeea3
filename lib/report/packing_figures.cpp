// SPDX-License-Identifier: BSD-3-Clause
#include "report/packing_figures.h"

#include "report/history_figure.h"
#include "report/pair_figures.h"
#include "report/size_figures.h"

namespace jam {

std::vector<Figure> packing_figures(const Measurements& m, const Table& history) {
    std::vector<Figure> figures;
    if (!history.columns.empty())
        figures.push_back(history_figure(history, m.applied_pressure.trace() / 3.0));
    const bool has_backbone = m.statistics.rattler_count < m.statistics.particle_count;
    if (m.polydisperse()) {
        figures.push_back(cumulative_volume_figure(m.cumulative_volume, m.power_law));
        if (has_backbone) {
            figures.push_back(pair_sizes_figure(m.pair_sizes));
            figures.push_back(size_coordination_figure(m.size_coordination, m.contact_numbers,
                                                       SizeCoordinationSettings{}.fit_from));
            figures.push_back(backbone_sizes_figure(m.backbone_sizes, m.power_law));
            figures.push_back(backbone_larger_figure(m.backbone_sizes));
        }
    }
    if (worth_drawing(m.forces.contact_counts)) figures.push_back(forces_figure(m.forces));
    if (worth_drawing(m.gaps.pair_counts)) figures.push_back(gaps_figure(m.gaps));
    figures.push_back(radial_figure(m.radial));
    return figures;
}

}  // namespace jam
