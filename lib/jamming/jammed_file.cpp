// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/jammed_file.h"

#include "packing/packing_file.h"

#include <array>
#include <vector>

namespace jam {

void save_jammed(const JamResult& result, const std::filesystem::path& path) {
    const PackingStatistics& now = result.measurement.statistics;
    std::vector<std::array<Index, 2>> pairs;
    pairs.reserve(result.measurement.network.contacts.size());
    for (const Contact& contact : result.measurement.network.contacts)
        pairs.push_back({contact.first, contact.second});
    PackingExtras extras;
    extras.numbers = {{"volume_fraction", now.volume_fraction},
                      {"coordination", now.coordination},
                      {"coordination_nr", now.coordination_nr},
                      {"rattler_fraction", now.rattler_fraction},
                      {"cundall", now.cundall},
                      {"kinetic_energy_per_particle", now.kinetic_energy_per_particle}};
    extras.tensors = {{"pressure", now.pressure}};
    extras.contacts = pairs;
    save_packing(result.measurement.packing, path, extras);
}

}  // namespace jam
