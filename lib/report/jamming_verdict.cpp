// SPDX-License-Identifier: BSD-3-Clause
#include "report/jamming_verdict.h"

#include "report/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace jam {

namespace {

JammingCriterion enough_contacts(const PackingStatistics& s) {
    const Count excess = s.excess_contact_count();
    const bool has_backbone = s.rattler_count < s.particle_count;
    return {"Does the backbone have the contacts that rigidity takes?",
            has_backbone
                ? fmt::format("{} contacts, {} than isostatic", grouped(s.contact_count_nr),
                              excess >= 0 ? grouped(excess) + " more" : grouped(-excess) + " fewer")
                : "there is no backbone",
            fmt::format("at least {}", grouped(s.isostatic_contact_count)),
            has_backbone && excess >= 0};
}

JammingCriterion balanced_forces(const PackingStatistics& s, double limit) {
    return {"Do the contact forces balance on every particle?",
            fmt::format("Cundall parameter C = {}", short_number(s.cundall)),
            fmt::format("at most {}", short_number(limit)), s.cundall <= limit};
}

/// Against the applied pressure where the packing says it, else against its own mean.
JammingCriterion even_pressure(const Measurements& m, double limit) {
    const Mat3& p = m.statistics.pressure;
    const double applied = m.applied_pressure.trace() / 3.0;
    const bool known = applied > 0.0;
    const double mean = p.trace() / 3.0;
    const Mat3 wanted = known ? m.applied_pressure : Mat3(Mat3::Identity() * mean);
    const double worst = (p - wanted).cwiseAbs().maxCoeff() / (known ? applied : mean);
    return {known ? "Is the internal pressure the applied one, in all six components?"
                  : "Is the internal pressure the same from all sides, without shear?",
            fmt::format("p = {}, worst component off by {} of it", short_number(mean),
                        short_number(worst)),
            fmt::format("at most {}", short_number(limit)), mean > 0.0 && worst <= limit};
}

JammingCriterion at_rest(const PackingStatistics& s, double limit) {
    return {
        "Is it at rest?",
        fmt::format("kinetic energy {} a particle", short_number(s.kinetic_energy_per_particle)),
        fmt::format("at most {}", short_number(limit)), s.kinetic_energy_per_particle <= limit};
}

/// Only where there is something to be stable.
std::optional<JammingCriterion> stable(const std::optional<Elasticity>& elasticity) {
    if (!elasticity || elasticity->particle_count == 0) return std::nullopt;
    return JammingCriterion{
        "Does it withstand any small push?",
        fmt::format("smallest eigenvalue of the enthalpy’s second derivatives {}",
                    short_number(elasticity->stability.smallest_eigenvalue)),
        "above 0", elasticity->stability.stable};
}

}  // namespace

bool JammingVerdict::jammed() const {
    return std::ranges::all_of(criteria, &JammingCriterion::holds);
}

std::string JammingVerdict::sentence() const {
    const auto missing = std::ranges::count(criteria, false, &JammingCriterion::holds);
    if (missing == 0) return "Jammed: every criterion holds.";
    return fmt::format("Not jammed: {} of {} criteria {} not hold.", missing, criteria.size(),
                       missing == 1 ? "does" : "do");
}

JammingVerdict judge(const Measurements& m, const JammingLimits& limits) {
    const PackingStatistics& s = m.statistics;
    JammingVerdict verdict{{enough_contacts(s), balanced_forces(s, limits.cundall),
                            even_pressure(m, limits.pressure), at_rest(s, limits.kinetic_energy)}};
    if (const auto criterion = stable(m.elasticity)) verdict.criteria.push_back(*criterion);
    return verdict;
}

}  // namespace jam
