// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/static_stress.h"

#include "core/parallel.h"

namespace jam {

namespace {

constexpr Count items_per_block = 4096;

/// Sum of |F_p| over the particles that `counts` tells to take.
template <typename Counts>
double sum_of_net_forces(const ForceNetwork& network, Counts&& counts) {
    const Count particle_count = network.rows.particle_count();
    return sum_blocks(particle_count, items_per_block, 0.0, [&](Count begin, Count end) {
        double sum = 0.0;
        for (auto i = static_cast<Index>(begin); i < end; ++i)
            if (counts(i)) sum += net_force(network, i).norm();
        return sum;
    });
}

double sum_of_contact_forces(std::span<const Contact> contacts) {
    const auto contact_count = static_cast<Count>(contacts.size());
    return sum_blocks(contact_count, items_per_block, 0.0, [&](Count begin, Count end) {
        double sum = 0.0;
        for (Count c = begin; c < end; ++c) sum += contacts[c].force;
        return sum;
    });
}

}  // namespace

Mat3 static_pressure(const Packing& packing, std::span<const Contact> contacts) {
    const Mat3 zero = Mat3::Zero();
    const auto contact_count = static_cast<Count>(contacts.size());
    const Mat3 virial =
        sum_blocks(contact_count, items_per_block, zero, [&](Count begin, Count end) {
            Mat3 sum = Mat3::Zero();
            for (Count c = begin; c < end; ++c) {
                const Contact& contact = contacts[c];
                const double mean_diameter =
                    0.5 * (packing.diameters[contact.first] + packing.diameters[contact.second]);
                const double distance = mean_diameter - contact.overlap;
                sum += contact.force * distance * contact.normal * contact.normal.transpose();
            }
            return sum;
        });
    return virial / packing.cell.volume();
}

Vec3 net_force(const ForceNetwork& network, Index particle) {
    Vec3 force = Vec3::Zero();
    for (const ContactEnd end : network.rows.row(particle)) {
        const Contact& contact = network.contacts[end.contact()];
        force += end.sign() * contact.force * contact.normal;
    }
    return force;
}

double cundall(const ForceNetwork& network) {
    return sum_of_net_forces(network, [](Index) { return true; }) /
           sum_of_contact_forces(network.contacts);
}

double cundall_nr(const ForceNetwork& network) {
    return sum_of_net_forces(network,
                             [&](Index i) { return network.rattlers.is_rattler[i] == 0; }) /
           sum_of_contact_forces(network.contacts);
}

}  // namespace jam
