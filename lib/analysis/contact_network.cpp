// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/contact_network.h"

#include "contacts/elastic_laws.h"
#include "core/check.h"
#include "core/parallel.h"

#include <tuple>

namespace jam {

namespace {

bool comes_before(const Contact& a, const Contact& b) {
    const auto key = [](const Contact& c) {
        return std::tuple(c.first, c.second, c.image[0], c.image[1], c.image[2]);
    };
    return key(a) < key(b);
}

}  // namespace

std::vector<Contact> find_contacts(const Packing& packing) {
    const NearSphereList near(wrap_spheres(packing), InteractionReach{});
    return with_elastic_law(packing.material, [&](const auto& law) {
        auto contacts = gather_pairs<Contact>(near, [&](const NearSpheres& pair, auto& found) {
            const double diameter_1 = packing.diameters[pair.first];
            const double diameter_2 = packing.diameters[pair.second];
            const double distance = pair.apart.norm();
            const double overlap = 0.5 * (diameter_1 + diameter_2) - distance;
            if (overlap <= 0.0) return;
            require(distance > 0.0,
                    "packing: particles {} and {} (by place, from 1) have the same center; remove "
                    "one of them",
                    pair.first + 1, pair.second + 1);
            found.push_back({pair.first, pair.second, pair.image, overlap,
                             law.force(overlap, diameter_1, diameter_2), pair.apart / distance});
        });
        sort_total_order(contacts, comes_before);
        return contacts;
    });
}

ContactRows contact_rows(Index particle_count, std::span<const Contact> contacts) {
    ContactRows rows;
    rows.row_begin.assign(static_cast<std::size_t>(particle_count) + 1, 0);
    for (const Contact& contact : contacts) {
        ++rows.row_begin[contact.first];
        ++rows.row_begin[contact.second];
    }
    rows.ends.resize(static_cast<std::size_t>(exclusive_scan(rows.row_begin)));
    std::vector<Count> next = rows.row_begin;
    for (Count c = 0; c < static_cast<Count>(contacts.size()); ++c) {
        rows.ends[next[contacts[c].first]++] = ContactEnd(c, false);
        rows.ends[next[contacts[c].second]++] = ContactEnd(c, true);
    }
    return rows;
}

}  // namespace jam
