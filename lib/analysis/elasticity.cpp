// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/elasticity.h"

#include "analysis/rattlers.h"
#include "analysis/static_stress.h"
#include "core/check.h"

namespace jam {

namespace {

double mean_pressure_among(const Packing& packing, const ForceNetwork& network,
                           const Rattlers& rattlers) {
    std::vector<Contact> bearing;
    for (const Contact& contact : network.contacts)
        if (rattlers.bears(contact)) bearing.push_back(contact);
    return static_pressure(packing, bearing).trace() / 3.0;
}

}  // namespace

Elasticity find_elasticity(const Packing& packing, const ForceNetwork& network,
                           Count most_particles) {
    const Rattlers held = find_rattlers(network.contacts, network.rows, contacts_that_hold);
    Elasticity result;
    result.particle_count = held.backbone_count();
    require(result.particle_count <= most_particles,
            "packing: {} particles are held; elastic moduli are found for at most {}",
            result.particle_count, most_particles);
    result.pressure = mean_pressure_among(packing, network, held);
    const EnthalpyHessian hessian =
        enthalpy_hessian(packing, network, held.is_rattler, result.pressure);
    result.stability = find_stability(hessian);
    if (result.stability.stable) result.moduli = elastic_moduli(hessian);
    return result;
}

}  // namespace jam
