// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/size_coordination.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

namespace {

/// Sums over the particles of a bin. Contacts are whole numbers: their sums are exact.
struct BinSums {
    Count particles = 0;
    Count contacts = 0;
    Count contacts_squared = 0;
    double diameter = 0.0;
    double area = 0.0;
};

/// Standard error of the mean number of contacts. Numbers that all agree still scatter below what
/// whole numbers can show: the variance is at least that of rounding, 1/12.
double error_of_mean(const BinSums& sums) {
    if (sums.particles < 2) return std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(sums.particles);
    const double mean = static_cast<double>(sums.contacts) / n;
    const double scatter = static_cast<double>(sums.contacts_squared) - n * mean * mean;
    return std::sqrt(std::max(scatter / (n - 1.0), 1.0 / 12.0) / n);
}

std::vector<BinSums> sum_by_size(std::span<const double> diameters, const Rattlers& rattlers,
                                 const Bins& bins) {
    std::vector<BinSums> sums(bins.count());
    for (std::size_t i = 0; i < diameters.size(); ++i) {
        if (rattlers.is_rattler[i] != 0) continue;
        BinSums& bin = sums[bins.bin_of(diameters[i])];
        const Count contacts = rattlers.contact_counts_nr[i];
        const double scaled = diameters[i] / bins.edges.back();
        ++bin.particles;
        bin.contacts += contacts;
        bin.contacts_squared += contacts * contacts;
        bin.diameter += diameters[i];
        bin.area += scaled * scaled;
    }
    return sums;
}

LinearFit fit_large(const SizeCoordination& points, double fit_from) {
    std::vector<double> x, y, errors;
    for (std::size_t b = 0; b < points.errors.size(); ++b) {
        if (points.scaled_areas[b] < fit_from || std::isnan(points.errors[b])) continue;
        x.push_back(points.scaled_areas[b]);
        y.push_back(points.excess_contacts[b]);
        errors.push_back(points.errors[b]);
    }
    return fit_line(x, y, errors);
}

}  // namespace

SizeCoordination size_coordination(std::span<const double> diameters, const Rattlers& rattlers,
                                   const SizeCoordinationSettings& settings) {
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    const Bins bins = logarithmic_bins(*smallest, *largest, settings.bins_per_decade);
    SizeCoordination result;
    for (const BinSums& sums : sum_by_size(diameters, rattlers, bins)) {
        if (sums.particles == 0) continue;
        const auto n = static_cast<double>(sums.particles);
        result.diameters.push_back(sums.diameter / n);
        result.scaled_areas.push_back(sums.area / n);
        result.excess_contacts.push_back(static_cast<double>(sums.contacts) / n - 3.0);
        result.errors.push_back(error_of_mean(sums));
        result.particle_counts.push_back(sums.particles);
    }
    result.fit = fit_large(result, settings.fit_from);
    return result;
}

Table table(const SizeCoordination& c) {
    return {{{"diameter", c.diameters},
             {"scaled_area", c.scaled_areas},
             {"excess_contacts", c.excess_contacts},
             {"error", c.errors},
             {"particles", {c.particle_counts.begin(), c.particle_counts.end()}}}};
}

}  // namespace jam
