// SPDX-License-Identifier: BSD-3-Clause
// A statistic of one's own: the fabric tensor <n n^T> of the force-bearing contacts, whose three
// principal values are all 1/3 in an isotropic packing.
//     own_statistic packing.h5
#include "analysis/force_network.h"
#include "packing/packing_io.h"

#include <Eigen/Eigenvalues>

#include <cstdio>

/// Mean of n n^T over the contacts of the backbone; n the unit normal.
static jam::Mat3 fabric(const jam::ForceNetwork& network) {
    jam::Mat3 sum = jam::Mat3::Zero();
    for (const jam::Contact& contact : network.contacts)
        if (network.rattlers.bears(contact)) sum += contact.normal * contact.normal.transpose();
    return sum / static_cast<double>(network.rattlers.contact_count_nr);
}

int main(int argc, char** argv) try {
    const jam::Packing packing = jam::read_packing(argc > 1 ? argv[1] : "packing.h5");
    const jam::ForceNetwork network = jam::find_force_network(packing);
    const Eigen::SelfAdjointEigenSolver<jam::Mat3> principal(fabric(network),
                                                             Eigen::EigenvaluesOnly);
    const jam::Vec3 values = principal.eigenvalues();
    std::printf("%lld contacts, principal fabric %.4f %.4f %.4f, sum %.4f\n",
                static_cast<long long>(network.rattlers.contact_count_nr), values[0], values[1],
                values[2], values.sum());
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
