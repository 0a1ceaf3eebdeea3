// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/measured_file.h"

#include "packing/packing_file.h"

#include <array>
#include <vector>

namespace jam {

void save_measured(const Packing& packing, const ForceNetwork& network,
                   const PackingStatistics& statistics, const std::filesystem::path& path) {
    std::vector<std::array<Index, 2>> pairs;
    pairs.reserve(network.contacts.size());
    for (const Contact& contact : network.contacts)
        pairs.push_back({contact.first, contact.second});
    PackingExtras extras;
    extras.numbers = {{"volume_fraction", statistics.volume_fraction},
                      {"coordination", statistics.coordination},
                      {"coordination_nr", statistics.coordination_nr},
                      {"rattler_fraction", statistics.rattler_fraction},
                      {"cundall", statistics.cundall},
                      {"kinetic_energy_per_particle", statistics.kinetic_energy_per_particle}};
    extras.tensors = {{"pressure", statistics.pressure}};
    extras.contacts = pairs;
    save_packing(packing, path, extras);
}

}  // namespace jam
