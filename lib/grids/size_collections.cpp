// SPDX-License-Identifier: BSD-3-Clause
#include "grids/size_collections.h"

#include "core/check.h"

#include <algorithm>
#include <cmath>

namespace jam {

SizeCollections collections_between(std::span<const double> diameters,
                                    std::span<const double> bounds) {
    const std::size_t intervals = bounds.size() + 1;
    std::vector<double> largest(intervals, 0.0);
    std::vector<Index> members(intervals, 0);
    for (const double diameter : diameters) {
        const auto bound = std::lower_bound(bounds.begin(), bounds.end(), diameter);
        const auto c = static_cast<std::size_t>(bound - bounds.begin());
        largest[c] = std::max(largest[c], diameter);
        ++members[c];
    }
    SizeCollections collections;
    collections.begin.push_back(0);
    for (std::size_t c = 0; c < intervals; ++c) {
        if (members[c] == 0) continue;
        collections.upper.push_back(largest[c]);
        collections.begin.push_back(collections.begin.back() + members[c]);
    }
    return collections;
}

SizeCollections geometric_collections(std::span<const double> diameters,
                                      const CollectionSettings& settings) {
    require(!diameters.empty(), "collections: there are no particles; give at least one diameter");
    require(settings.ratio > 1.0, "collections.ratio = {}: must be above 1", settings.ratio);
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    const double widest = *largest / *smallest;
    const int intervals =
        std::max(1, static_cast<int>(std::round(std::log(widest) / std::log(settings.ratio))));
    std::vector<double> bounds;
    for (int c = 1; c < intervals; ++c)
        bounds.push_back(*smallest * std::pow(widest, double(c) / intervals));
    return collections_between(diameters, bounds);
}

SizeCollections linear_collections(std::span<const double> diameters, int intervals) {
    require(!diameters.empty(), "collections: there are no particles; give at least one diameter");
    require(intervals >= 1, "collections.intervals = {}: must be at least 1", intervals);
    const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
    std::vector<double> bounds;
    for (int c = 1; c < intervals; ++c)
        bounds.push_back(*smallest + (*largest - *smallest) * c / intervals);
    return collections_between(diameters, bounds);
}

int collection_of(const SizeCollections& collections, double diameter) {
    const auto upper =
        std::lower_bound(collections.upper.begin(), collections.upper.end(), diameter);
    return static_cast<int>(upper - collections.upper.begin());
}

}  // namespace jam
