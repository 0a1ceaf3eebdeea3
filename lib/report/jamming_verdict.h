// SPDX-License-Identifier: BSD-3-Clause
// Is it jammed? Said in plain words, criterion by criterion, from the packing alone.
#pragma once

#include "report/measurements.h"

#include <string>
#include <vector>

namespace jam {

/// Limits of the criteria; those of Monti et al., Methods, where they give one.
struct JammingLimits {
    double cundall = 1e-6;
    double kinetic_energy = 1e-13;  ///< a particle
    double pressure = 1e-3;         ///< of any of the six components, over the mean pressure
};

struct JammingCriterion {
    std::string question;
    std::string finding;
    std::string limit;
    bool holds = false;
};

struct JammingVerdict {
    std::vector<JammingCriterion> criteria;

    bool jammed() const;
    /// One sentence: jammed, or what is missing.
    std::string sentence() const;
};

JammingVerdict judge(const Measurements& measurements, const JammingLimits& limits = {});

}  // namespace jam
