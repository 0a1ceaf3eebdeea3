// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/rattlers.h"

#include <utility>

namespace jam {

namespace {

/// Takes away every particle in `queue` and, as they drop below `threshold`, their partners.
/// `counts` holds the contacts that each particle still has.
void remove_one_by_one(std::span<const Contact> contacts, const ContactRows& rows, int threshold,
                       std::vector<Index> queue, std::vector<int>& counts,
                       std::vector<std::uint8_t>& is_rattler) {
    for (std::size_t next = 0; next < queue.size(); ++next) {
        for (const ContactEnd end : rows.row(queue[next])) {
            const Index partner = end.partner(contacts);
            --counts[partner];
            if (is_rattler[partner] != 0 || counts[partner] >= threshold) continue;
            is_rattler[partner] = 1;
            queue.push_back(partner);
        }
    }
}

}  // namespace

void count_backbone(std::span<const Contact> contacts, const ContactRows& rows,
                    Rattlers& rattlers) {
    const Index particle_count = rows.particle_count();
    rattlers.contact_counts_nr.assign(particle_count, 0);
    rattlers.rattler_count = 0;
    for (Index i = 0; i < particle_count; ++i) rattlers.rattler_count += rattlers.is_rattler[i];
    rattlers.contact_count_nr = 0;
    for (const Contact& contact : contacts) {
        if (!rattlers.bears(contact)) continue;
        ++rattlers.contact_count_nr;
        ++rattlers.contact_counts_nr[contact.first];
        ++rattlers.contact_counts_nr[contact.second];
    }
}

Rattlers find_rattlers(std::span<const Contact> contacts, const ContactRows& rows, int threshold) {
    const Index particle_count = rows.particle_count();
    Rattlers result;
    result.is_rattler.assign(particle_count, 0);
    std::vector<int> counts(particle_count);
    std::vector<Index> loose;
    for (Index i = 0; i < particle_count; ++i) {
        counts[i] = rows.contact_count(i);
        if (counts[i] >= threshold) continue;
        result.is_rattler[i] = 1;
        loose.push_back(i);
    }
    remove_one_by_one(contacts, rows, threshold, std::move(loose), counts, result.is_rattler);
    count_backbone(contacts, rows, result);
    return result;
}

}  // namespace jam
