// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/gap_distribution.h"

#include "core/check.h"

#include <algorithm>

namespace jam {

namespace {

/// Gaps of pairs within the backbone, up to `largest`.
std::vector<double> backbone_gaps(const Packing& packing, const Rattlers& rattlers,
                                  const WrappedSpheres& wrapped, double largest) {
    InteractionReach reach;
    reach.strain_margin = largest;
    const NearSphereList near(wrapped, reach);
    return gather_pairs<double>(near, [&](const NearSpheres& pair, std::vector<double>& gaps) {
        if (rattlers.is_rattler[pair.first] != 0 || rattlers.is_rattler[pair.second] != 0) return;
        const double diameters = packing.diameters[pair.first] + packing.diameters[pair.second];
        const double gap = 2.0 * pair.apart.norm() / diameters - 1.0;
        if (gap > 0.0 && gap <= largest) gaps.push_back(gap);
    });
}

/// Overlap over the mean diameter of the two, on average.
double mean_overlap(const Packing& packing, std::span<const Contact> contacts) {
    double sum = 0.0;
    for (const Contact& contact : contacts)
        sum += 2.0 * contact.overlap /
               (packing.diameters[contact.first] + packing.diameters[contact.second]);
    return contacts.empty() ? 0.0 : sum / static_cast<double>(contacts.size());
}

}  // namespace

GapDistribution gap_distribution(const Packing& packing, const ForceNetwork& network,
                                 const GapDistributionSettings& settings) {
    const WrappedSpheres wrapped = wrap_spheres(packing);
    const double widest = *std::max_element(packing.diameters.begin(), packing.diameters.end());
    const double cell_allows = wrapped.cell.perpendicular_widths().minCoeff() / widest - 1.0;
    const double largest = std::min(settings.largest, cell_allows * (1.0 - 1e-9));
    require(largest > settings.smallest,
            "gaps: the cell is as narrow as its largest sphere, or gaps.largest is not above "
            "gaps.smallest ({}); use a larger cell",
            settings.smallest);
    const std::vector<double> gaps = backbone_gaps(packing, network.rattlers, wrapped, largest);

    GapDistribution result;
    result.bins = logarithmic_bins(settings.smallest, largest, settings.bins_per_decade);
    result.pair_counts.assign(result.bins.count(), 0);
    for (const double gap : gaps)
        if (const int bin = result.bins.bin_of(gap); bin >= 0) ++result.pair_counts[bin];
    const auto particles =
        static_cast<double>(std::max<Count>(1, network.rattlers.backbone_count()));
    for (int b = 0; b < result.bins.count(); ++b)
        result.density.push_back(2.0 * static_cast<double>(result.pair_counts[b]) /
                                 (particles * result.bins.width(b)));
    const double fit_from =
        std::max(settings.smallest, 10.0 * mean_overlap(packing, network.contacts));
    result.small_gaps = fit_power_law(gaps, fit_from, std::min(settings.fit_up_to, largest));
    return result;
}

Table table(const GapDistribution& d) {
    return {{{"gap_low", d.bins.lower()},
             {"gap_high", d.bins.upper()},
             {"density", d.density},
             {"pairs", {d.pair_counts.begin(), d.pair_counts.end()}}}};
}

}  // namespace jam
