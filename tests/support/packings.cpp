// SPDX-License-Identifier: BSD-3-Clause
#include "support/packings.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace jam::test {

namespace {

double draw_uniform(std::uint64_t seed, int id, std::uint32_t draw) {
    return uniform(seed, RandomStream::tests, static_cast<std::uint64_t>(id), draw);
}

Packing crystal(int cells, double lattice_constant, double diameter,
                const std::vector<Vec3>& basis) {
    std::vector<Vec3> positions;
    for (int x = 0; x < cells; ++x)
        for (int y = 0; y < cells; ++y)
            for (int z = 0; z < cells; ++z)
                for (const Vec3& site : basis)
                    positions.push_back(lattice_constant * (Vec3(x, y, z) + site));
    std::vector<double> diameters(positions.size(), diameter);
    return make_packing(Mat3::Identity() * (cells * lattice_constant), std::move(positions),
                        std::move(diameters));
}

}  // namespace

Packing make_packing(const Mat3& edges_in_columns, std::vector<Vec3> positions,
                     std::vector<double> diameters) {
    Packing packing;
    packing.cell = PeriodicCell(edges_in_columns);
    packing.positions = std::move(positions);
    packing.diameters = std::move(diameters);
    packing.ids.resize(packing.positions.size());
    std::iota(packing.ids.begin(), packing.ids.end(), 1);
    return packing;
}

Packing simple_cubic(int cells, double lattice_constant, double diameter) {
    return crystal(cells, lattice_constant, diameter, {Vec3(0, 0, 0)});
}

Packing cubic_slab() {
    Packing slab = simple_cubic(3, 0.99, 1.0);
    slab.cell = PeriodicCell(Vec3(2.97, 2.97, 9.0).asDiagonal());
    return slab;
}

Packing face_centered_cubic(int cells, double lattice_constant, double diameter) {
    return crystal(cells, lattice_constant, diameter,
                   {Vec3(0, 0, 0), Vec3(0, 0.5, 0.5), Vec3(0.5, 0, 0.5), Vec3(0.5, 0.5, 0)});
}

Mat3 random_edges(double side, std::uint64_t seed) {
    auto draw = [&, n = 0u]() mutable { return draw_uniform(seed, -1, n++); };
    Mat3 edges = Mat3::Zero();
    for (int k = 0; k < 3; ++k) edges(k, k) = side * (0.9 + 0.2 * draw());
    edges(0, 1) = edges(0, 0) * (draw() - 0.5);
    edges(0, 2) = edges(0, 0) * (draw() - 0.5);
    edges(1, 2) = edges(1, 1) * (draw() - 0.5);
    return edges;
}

Packing random_spheres(const Mat3& edges_in_columns, int count, double size_ratio,
                       std::uint64_t seed) {
    std::vector<Vec3> positions;
    std::vector<double> diameters;
    for (int i = 0; i < count; ++i) {
        const Vec3 fractional(draw_uniform(seed, i, 0), draw_uniform(seed, i, 1),
                              draw_uniform(seed, i, 2));
        positions.push_back(edges_in_columns * fractional);
        diameters.push_back(std::pow(size_ratio, draw_uniform(seed, i, 3)));
    }
    return make_packing(edges_in_columns, std::move(positions), std::move(diameters));
}

Packing moved(Packing packing, const std::function<Vec3(const Vec3&)>& move) {
    for (Vec3& position : packing.positions) position = move(position);
    return packing;
}

Packing relabelled(const Packing& packing, const std::vector<Index>& order) {
    Packing result = packing;
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.positions[i] = packing.positions[order[i]];
        result.diameters[i] = packing.diameters[order[i]];
        result.ids[i] = packing.ids[order[i]];
        if (!packing.velocities.empty()) result.velocities[i] = packing.velocities[order[i]];
    }
    return result;
}

std::vector<Index> shuffled(Index count, std::uint64_t seed) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (Index i = count - 1; i > 0; --i)
        std::swap(order[i], order[static_cast<Index>(draw_uniform(seed, i, 7) * (i + 1))]);
    return order;
}

}  // namespace jam::test
