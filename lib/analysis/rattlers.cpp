// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/rattlers.h"

#include <algorithm>

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

Rattlers find_rattlers(std::span<const Contact> contacts, const ContactRows& rows, int threshold) {
    const Index particle_count = rows.particle_count();
    Rattlers result;
    result.is_rattler.assign(particle_count, 0);
    result.contact_counts_nr.resize(particle_count);
    std::vector<Index> loose;
    for (Index i = 0; i < particle_count; ++i) {
        result.contact_counts_nr[i] = rows.contact_count(i);
        if (rows.contact_count(i) >= threshold) continue;
        result.is_rattler[i] = 1;
        loose.push_back(i);
    }
    remove_one_by_one(contacts, rows, threshold, std::move(loose), result.contact_counts_nr,
                      result.is_rattler);
    Count ends = 0;
    for (Index i = 0; i < particle_count; ++i) {
        if (result.is_rattler[i] != 0) result.contact_counts_nr[i] = 0;
        result.rattler_count += result.is_rattler[i];
        ends += result.contact_counts_nr[i];
    }
    result.contact_count_nr = ends / 2;
    return result;
}

}  // namespace jam
