// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/static_stress.h"

#include "core/parallel.h"

namespace jam {

namespace {

constexpr Count block_size = 4096;

template <typename Counts>
double force_ratio(const ForceNetwork& network, Counts&& counts) {
    const double net = sum_blocks(
        Count{network.rows.particle_count()}, block_size, 0.0, [&](Count begin, Count end) {
            double sum = 0.0;
            for (Count i = begin; i < end; ++i) {
                Vec3 force = Vec3::Zero();
                for (const ContactEnd at : network.rows.row(static_cast<Index>(i))) {
                    const Contact& contact = network.contacts[at.contact()];
                    if (counts(contact)) force += at.sign() * contact.force * contact.normal;
                }
                sum += force.norm();
            }
            return sum;
        });
    const auto contact_count = static_cast<Count>(network.contacts.size());
    const double total = sum_blocks(contact_count, block_size, 0.0, [&](Count begin, Count end) {
        double sum = 0.0;
        for (Count c = begin; c < end; ++c)
            if (counts(network.contacts[c])) sum += network.contacts[c].force;
        return sum;
    });
    return net / total;
}

}  // namespace

Mat3 static_pressure(const Packing& packing, std::span<const Contact> contacts) {
    const Mat3 zero = Mat3::Zero();
    const auto contact_count = static_cast<Count>(contacts.size());
    const Mat3 virial = sum_blocks(contact_count, block_size, zero, [&](Count begin, Count end) {
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

double cundall(const ForceNetwork& network) {
    return force_ratio(network, [](const Contact&) { return true; });
}

double cundall_nr(const ForceNetwork& network) {
    return force_ratio(network,
                       [&](const Contact& contact) { return network.rattlers.bears(contact); });
}

}  // namespace jam
