// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/brute_force_neighbors.h"

#include "core/check.h"

#include <algorithm>

namespace jam {

namespace {

/// Whether, of a sphere's image and its opposite, this is the one that stands for both.
bool leads(const Image& image) {
    for (int k = 0; k < 3; ++k)
        if (image[k] != 0) return image[k] > 0;
    return false;
}

void add_images_of_pair(const PeriodicCell& cell, std::span<const Sphere> spheres, Index i, Index j,
                        double reach, std::vector<NearPair>& pairs) {
    const Vec3 apart = spheres[i].center - spheres[j].center;
    for (std::uint32_t code = 0; code < image_count; ++code) {
        const Image image = image_of(code);
        if (i == j && !leads(image)) continue;
        if (cell.cartesian(apart - image.cast<double>()).squaredNorm() <= reach * reach)
            pairs.push_back({i, j, image});
    }
}

}  // namespace

NearPair canonical_pair(Index i, Index j, const Image& image) {
    const bool keep = i == j ? leads(image) : i < j;
    return keep ? NearPair{i, j, image} : NearPair{j, i, -image};
}

std::vector<NearPair> brute_force_neighbors(const PeriodicCell& cell,
                                            std::span<const Sphere> spheres, double strain_margin,
                                            double skin) {
    double largest = 0.0;
    for (const Sphere& sphere : spheres) largest = std::max(largest, sphere.diameter);
    const double largest_reach = largest * (1.0 + strain_margin) + 2.0 * skin;
    require(cell.perpendicular_widths().minCoeff() >= largest_reach,
            "cell: perpendicular width {} is below the largest reach {}; use a larger cell",
            cell.perpendicular_widths().minCoeff(), largest_reach);

    std::vector<NearPair> pairs;
    const auto count = static_cast<Index>(spheres.size());
    for (Index i = 0; i < count; ++i) {
        for (Index j = i; j < count; ++j) {
            const double diameters = spheres[i].diameter + spheres[j].diameter;
            const double reach = 0.5 * diameters * (1.0 + strain_margin) + 2.0 * skin;
            add_images_of_pair(cell, spheres, i, j, reach, pairs);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<NearPair> canonical_pairs(const NeighborList& list) {
    std::vector<NearPair> pairs;
    for (Index i = 0; i < list.particle_count(); ++i)
        for (const Neighbor neighbor : list.row(i))
            pairs.push_back(canonical_pair(i, neighbor.particle(), image_of(neighbor.image())));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace jam
