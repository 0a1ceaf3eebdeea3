// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/coordination.h"

#include "core/check.h"

#include <algorithm>

namespace jam {

namespace {

double mean_count(Count contacts, Count particles) {
    return particles == 0 ? 0.0
                          : 2.0 * static_cast<double>(contacts) / static_cast<double>(particles);
}

}  // namespace

double coordination(const ForceNetwork& network) {
    return mean_count(static_cast<Count>(network.contacts.size()), network.rows.particle_count());
}

double coordination_nr(const ForceNetwork& network) {
    return mean_count(network.rattlers.contact_count_nr, network.rattlers.backbone_count());
}

Count isostatic_contact_count(Count backbone_count, int free_cell_components) {
    require(free_cell_components >= 0 && free_cell_components <= 6,
            "free cell components: {} is not in 0..6", free_cell_components);
    if (backbone_count == 0) return 0;
    return 3 * backbone_count - 3 + std::max(1, free_cell_components);
}

}  // namespace jam
