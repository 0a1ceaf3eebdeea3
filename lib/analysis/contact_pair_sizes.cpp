// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/contact_pair_sizes.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

/// Of the part of the (D1, D2) plane that a pair of bins covers: on the diagonal only the half with
/// D2 <= D1.
double area_of(const Bins& bins, int larger, int smaller) {
    const double square = bins.width(larger) * bins.width(smaller);
    return larger == smaller ? 0.5 * square : square;
}

std::vector<int> bins_of(const Bins& bins, std::span<const double> diameters) {
    std::vector<int> result;
    result.reserve(diameters.size());
    for (const double diameter : diameters) result.push_back(bins.bin_of(diameter));
    return result;
}

}  // namespace

std::pair<double, double> ContactPairSizes::most_probable() const {
    Eigen::Index larger = 0;
    Eigen::Index smaller = 0;
    joint.maxCoeff(&larger, &smaller);
    const auto middle = [&](Eigen::Index b) {
        return std::sqrt(bins.edges[b] * bins.edges[b + 1]);
    };
    return {middle(larger), middle(smaller)};
}

ContactPairSizes contact_pair_sizes(std::span<const double> diameters,
                                    std::span<const Contact> contacts, int bins_per_decade) {
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    ContactPairSizes result;
    result.bins = logarithmic_bins(*smallest, *largest, bins_per_decade);
    const Bins& bins = result.bins;
    const int count = bins.count();
    result.contact_counts.setZero(count, count);
    const std::vector<int> bin = bins_of(bins, diameters);
    for (const Contact& contact : contacts) {
        const auto [low, high] = std::minmax(bin[contact.first], bin[contact.second]);
        ++result.contact_counts(high, low);
    }
    std::vector<Count> particle_counts(count, 0);
    for (const int b : bin) ++particle_counts[b];
    const std::vector<double> size_density = as_density(bins, particle_counts);

    result.joint.setZero(count, count);
    result.conditional.setZero(count, count);
    const double total = std::max(1.0, static_cast<double>(contacts.size()));
    for (int larger = 0; larger < count; ++larger) {
        for (int smaller = 0; smaller <= larger; ++smaller) {
            const auto found = static_cast<double>(result.contact_counts(larger, smaller));
            if (found == 0.0) continue;
            result.joint(larger, smaller) = found / total / area_of(bins, larger, smaller);
            result.conditional(larger, smaller) =
                result.joint(larger, smaller) / size_density[larger];
        }
    }
    return result;
}

Table table(const ContactPairSizes& sizes) {
    Table result{{{"diameter_1_low", {}},
                  {"diameter_1_high", {}},
                  {"diameter_2_low", {}},
                  {"diameter_2_high", {}},
                  {"joint", {}},
                  {"conditional", {}},
                  {"contacts", {}}}};
    for (int larger = 0; larger < sizes.bins.count(); ++larger) {
        for (int smaller = 0; smaller <= larger; ++smaller) {
            const double row[] = {sizes.bins.edges[larger],
                                  sizes.bins.edges[larger + 1],
                                  sizes.bins.edges[smaller],
                                  sizes.bins.edges[smaller + 1],
                                  sizes.joint(larger, smaller),
                                  sizes.conditional(larger, smaller),
                                  static_cast<double>(sizes.contact_counts(larger, smaller))};
            for (std::size_t c = 0; c < std::size(row); ++c)
                result.columns[c].values.push_back(row[c]);
        }
    }
    return result;
}

}  // namespace jam
