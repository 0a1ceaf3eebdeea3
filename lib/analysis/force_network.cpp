// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/force_network.h"

#include "core/check.h"

namespace jam {

ForceNetwork find_force_network(const Packing& packing, int rattler_threshold) {
    require(rattler_threshold >= 1 && rattler_threshold <= 100,
            "rattler threshold: {} is not in 1..100; give the number of contacts below which a "
            "particle is a rattler (3 in the paper)",
            rattler_threshold);
    ForceNetwork network;
    network.rattler_threshold = rattler_threshold;
    network.contacts = find_contacts(packing);
    network.rows = contact_rows(static_cast<Index>(packing.size()), network.contacts);
    network.rattlers = find_rattlers(network.contacts, network.rows, rattler_threshold);
    return network;
}

}  // namespace jam
