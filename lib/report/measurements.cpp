// SPDX-License-Identifier: BSD-3-Clause
#include "report/measurements.h"

namespace jam {

Measurements measure(const Packing& packing, const ForceNetwork& network) {
    const std::vector<double>& diameters = packing.diameters;
    Measurements m;
    m.statistics = packing_statistics(packing, network);
    m.applied_pressure = packing.applied_pressure;
    m.rod_fraction = rod_packing_fraction(diameters, rod_model_of_reports);
    m.cumulative_volume = cumulative_volume(diameters);
    m.power_law = fit_sizes(diameters);
    m.pair_sizes = contact_pair_sizes(diameters, network.contacts);
    m.size_coordination = size_coordination(diameters, network.rattlers);
    m.contact_numbers = contact_numbers(network.rattlers);
    m.backbone_sizes = backbone_sizes(diameters, network.rattlers);
    m.forces = force_distribution(network);
    m.gaps = gap_distribution(packing, network);
    m.radial = radial_distribution(packing);
    return m;
}

}  // namespace jam
