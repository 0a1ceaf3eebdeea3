// SPDX-License-Identifier: BSD-3-Clause
// What every statistic is computed from: the contacts, by particle, and who bears load.
#pragma once

#include "analysis/contact_network.h"
#include "analysis/rattlers.h"

namespace jam {

struct ForceNetwork {
    std::vector<Contact> contacts;
    ContactRows rows;
    Rattlers rattlers;
    int rattler_threshold = default_rattler_threshold;
};

/// Throws InputError as find_contacts does, and when `rattler_threshold` is not in [1, 100].
ForceNetwork find_force_network(const Packing& packing,
                                int rattler_threshold = default_rattler_threshold);

}  // namespace jam
