// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/packing_statistics.h"

#include "analysis/coordination.h"
#include "analysis/static_stress.h"
#include "analysis/unheld.h"
#include "core/check.h"
#include "core/parallel.h"

#include <algorithm>

namespace jam {

namespace {

constexpr Count block_size = 4096;

/// Sum of value(i) over i in [0, count), the same for any number of threads.
template <typename Value>
double sum_over(Count count, Value&& value) {
    return sum_blocks(count, block_size, 0.0, [&](Count begin, Count end) {
        double sum = 0.0;
        for (Count i = begin; i < end; ++i) sum += value(i);
        return sum;
    });
}

void set_volume_fractions(const Packing& packing, const Rattlers& rattlers,
                          PackingStatistics& statistics) {
    const auto volume = [&](Count i) { return sphere_volume(packing.diameters[i]); };
    const double all = sum_over(packing.size(), volume);
    const double backbone = sum_over(
        packing.size(), [&](Count i) { return rattlers.is_rattler[i] == 0 ? volume(i) : 0.0; });
    statistics.volume_fraction = all / packing.cell.volume();
    statistics.volume_fraction_nr = backbone / packing.cell.volume();
}

void set_overlaps(const Packing& packing, std::span<const Contact> contacts,
                  PackingStatistics& statistics) {
    const auto relative_overlap = [&](const Contact& contact) {
        return contact.overlap /
               std::min(packing.diameters[contact.first], packing.diameters[contact.second]);
    };
    for (const Contact& contact : contacts)
        statistics.largest_overlap =
            std::max(statistics.largest_overlap, relative_overlap(contact));
    const auto count = static_cast<Count>(contacts.size());
    const double sum = sum_over(count, [&](Count c) { return relative_overlap(contacts[c]); });
    statistics.mean_overlap = count == 0 ? 0.0 : sum / static_cast<double>(count);
}

double kinetic_energy(const Packing& packing) {
    return sum_over(static_cast<Count>(packing.velocities.size()), [&](Count i) {
        const double mass = packing.material.density * sphere_volume(packing.diameters[i]);
        return 0.5 * mass * packing.velocities[i].squaredNorm();
    });
}

}  // namespace

PackingStatistics packing_statistics(const Packing& packing, const ForceNetwork& network) {
    require(packing.size() > 0, "packing: it holds no particles; nothing can be measured");
    const auto [smallest, largest] =
        std::minmax_element(packing.diameters.begin(), packing.diameters.end());
    const auto particle_count = static_cast<double>(packing.size());

    PackingStatistics statistics;
    statistics.particle_count = packing.size();
    statistics.size_ratio = *largest / *smallest;
    set_volume_fractions(packing, network.rattlers, statistics);
    statistics.coordination = coordination(network);
    statistics.coordination_nr = coordination_nr(network);
    statistics.rattler_threshold = network.rattler_threshold;
    statistics.rattler_count = network.rattlers.rattler_count;
    statistics.rattler_fraction =
        static_cast<double>(network.rattlers.rattler_count) / particle_count;
    statistics.unheld_count = find_unheld(network.contacts, network.rows).rattler_count;
    statistics.contact_count = static_cast<Count>(network.contacts.size());
    statistics.contact_count_nr = network.rattlers.contact_count_nr;
    statistics.isostatic_contact_count = isostatic_contact_count(network.rattlers.backbone_count());
    statistics.cundall = cundall(network);
    statistics.cundall_nr = cundall_nr(network);
    statistics.pressure = static_pressure(packing, network.contacts);
    statistics.cell = packing.cell.matrix().transpose();
    set_overlaps(packing, network.contacts, statistics);
    statistics.kinetic_energy_per_particle = kinetic_energy(packing) / particle_count;
    return statistics;
}

}  // namespace jam
