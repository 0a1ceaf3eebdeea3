// SPDX-License-Identifier: BSD-3-Clause
#include "grids/collection_choice.h"

#include "grids/collection_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace jam {

namespace {

/// What the cost depends on of one collection.
struct CollectionModel {
    double members = 0.0;
    double largest_share = 0.0;                      ///< of the reach
    double share = 0.0, squared = 0.0, cubed = 0.0;  ///< means of the share and its powers
    double bin_edge = 0.0;
    double bins_along = 0.0;  ///< each edge of the cell
    double occupied = 0.0;    ///< bins that hold a member
    double occupancy = 0.0;   ///< members of such a bin

    /// Half the diagonal of the box around the members of a bin.
    double bounds() const {
        const double box = bin_edge * (occupancy - 1.0) / (occupancy + 1.0);
        return 0.5 * std::numbers::sqrt3 * box;
    }
};

double volume_of(std::span<const double> diameters) {
    double sum = 0.0;
    for (const double diameter : diameters) sum += std::numbers::pi / 6.0 * std::pow(diameter, 3);
    return sum;
}

std::vector<CollectionModel> models_of(std::span<const double> diameters,
                                       const SizeCollections& collections,
                                       const InteractionReach& reach, double edge) {
    std::vector<CollectionModel> models(collections.upper.size());
    for (const double diameter : diameters) {
        CollectionModel& model =
            models[static_cast<std::size_t>(collection_of(collections, diameter))];
        const double share = reach.of(diameter);
        model.members += 1.0;
        model.largest_share = std::max(model.largest_share, share);
        model.share += share;
        model.squared += share * share;
        model.cubed += share * share * share;
    }
    const PeriodicCell cell = PeriodicCell::cubic(edge);
    for (CollectionModel& model : models) {
        for (double* sum : {&model.share, &model.squared, &model.cubed}) *sum /= model.members;
        const auto members = static_cast<Index>(model.members);
        const double width = bin_width(cell.volume(), members, model.largest_share);
        model.bins_along = bins_along_edges(cell, width, members)[0];
        model.bin_edge = edge / model.bins_along;
        const double bins = std::pow(model.bins_along, 3);
        model.occupied = bins * -std::expm1(-model.members / bins);
        model.occupancy = model.members / model.occupied;
    }
    return models;
}

/// A bin of `own` looks into the grid of `other`: bins it visits, and candidates it keeps.
struct Look {
    double visits;
    double kept;
};
Look look(const CollectionModel& own, const CollectionModel& other, bool same, double edge) {
    const double bounds = own.bounds() + own.largest_share;
    const double half = same ? 0.5 : 1.0;
    const double along = std::min(2.0 * (bounds + other.largest_share) / other.bin_edge + 1.0,
                                  3.0 * other.bins_along);
    const double visits = half * std::pow(along, 3);
    const double within = std::pow(bounds, 3) + 3.0 * bounds * bounds * other.share +
                          3.0 * bounds * other.squared + other.cubed;
    const double kept =
        half * 4.0 / 3.0 * std::numbers::pi * within * other.members / std::pow(edge, 3);
    return {visits, kept};
}

}  // namespace

double search_cost(std::span<const double> diameters, const SizeCollections& collections,
                   const InteractionReach& reach, double volume_fraction,
                   const SearchCosts& costs) {
    const double edge = std::cbrt(volume_of(diameters) / volume_fraction);
    const std::vector<CollectionModel> models = models_of(diameters, collections, reach, edge);
    double sum = 0.0;
    for (std::size_t c = 0; c < models.size(); ++c) {
        const CollectionModel& own = models[c];
        double visits = 0.0;
        double kept = 0.0;
        for (std::size_t other = c; other < models.size(); ++other) {
            const Look seen = look(own, models[other], other == c, edge);
            visits += seen.visits;
            kept += seen.kept;
        }
        const double vectors = own.occupancy * (kept / 16.0 + 0.5);
        sum += own.members * costs.particle +
               own.occupied * (visits * costs.visit + vectors * costs.vector);
    }
    return sum / static_cast<double>(diameters.size());
}

SizeCollections cheapest_collections(std::span<const double> diameters,
                                     const InteractionReach& reach) {
    const auto [smallest, largest] = std::ranges::minmax_element(diameters);
    const double widest = *largest / *smallest;
    const int most = std::max(1, static_cast<int>(std::log(widest) / std::log(1.5)));
    SizeCollections cheapest = collections_between(diameters, {});
    double least = search_cost(diameters, cheapest, reach);
    for (int intervals = 2; intervals <= most; ++intervals) {
        SizeCollections collections =
            geometric_collections(diameters, {.ratio = std::pow(widest, 1.0 / intervals)});
        const double cost = search_cost(diameters, collections, reach);
        if (cost >= least) continue;
        least = cost;
        cheapest = std::move(collections);
    }
    return cheapest;
}

}  // namespace jam
