// SPDX-License-Identifier: BSD-3-Clause
#include "force_schemes.h"

#include "core/check.h"

#include <bit>
#include <cmath>

namespace jam::bench {

namespace {

constexpr Count rows_per_cell = 1024;

/// One pair in plain scalar code on 32-byte records, the form that is fastest without tiles.
class PairLaw {
  public:
    explicit PairLaw(const PairSystem& system)
        : h_(system.cell.matrix()),
          spheres_(system.particles.spheres.data()),
          motions_(system.particles.motions.data()),
          stiffness_(system.material.stiffness),
          damping_(system.material.damping) {}

    /// Load on particle i from its neighbor, and what it adds to the sums (times `share`).
    Double4 operator()(Index i, Neighbor neighbor, double share, PairSums& sums) const {
        const Sphere& first = spheres_[i];
        const Sphere& second = spheres_[neighbor.particle()];
        const ImageShift& shift = image_shifts[neighbor.image()];
        const double sx = first.center[0] - second.center[0] - shift.x;
        const double sy = first.center[1] - second.center[1] - shift.y;
        const double sz = first.center[2] - second.center[2] - shift.z;
        const double x = h_(0, 0) * sx + h_(0, 1) * sy + h_(0, 2) * sz;
        const double y = h_(1, 1) * sy + h_(1, 2) * sz;
        const double z = h_(2, 2) * sz;
        const double squared = x * x + y * y + z * z;
        const double reach = 0.5 * (first.diameter + second.diameter);
        if (squared >= reach * reach) return Double4{};
        const double distance = std::sqrt(squared);
        const double overlap = reach - distance;
        const double elastic = stiffness_ * overlap;
        const Motion& v = motions_[i];
        const Motion& w = motions_[neighbor.particle()];
        const double closing = x * (v.velocity[0] - w.velocity[0]) +
                               y * (v.velocity[1] - w.velocity[1]) +
                               z * (v.velocity[2] - w.velocity[2]);
        const double mass = v.mass * w.mass / (v.mass + w.mass);
        const double f = std::max(0.0, elastic - damping_ * mass * closing / distance) / distance;
        const Double4 load{f * x, f * y, f * z, 1.0};
        sums.energy += share * 0.5 * elastic * overlap;
        sums.virial_x += share * x * load;
        sums.virial_y += share * y * load;
        sums.virial_z += share * z * load;
        return load;
    }

  private:
    const Mat3& h_;
    const Sphere* spheres_;
    const Motion* motions_;
    double stiffness_, damping_;
};

Double4 reaction(const Double4& load) {
    return Double4{-load[0], -load[1], -load[2], load[3]};
}

void add_to(Load& load, const Double4& more) {
    store4(load4(load) + more, load);
}

PairSums sum_in_order(const std::vector<PairSums>& parts) {
    PairSums sums;
    for (const PairSums& part : parts) sums += part;
    return sums;
}

}  // namespace

PairSums& PairSums::operator+=(const PairSums& other) {
    energy += other.energy;
    virial_x += other.virial_x;
    virial_y += other.virial_y;
    virial_z += other.virial_z;
    return *this;
}

ColoredCells::ColoredCells(const PairSystem& system) {
    constexpr int most_colors = 256;
    using Colors = std::array<std::uint64_t, most_colors / 64>;
    std::vector<Colors> taken(system.particles.spheres.size(), Colors{});
    const Count rows = system.pairs.particle_count();
    for (Count cell = 0; cell < block_count(rows, rows_per_cell); ++cell) {
        const auto begin = static_cast<Index>(cell * rows_per_cell);
        const auto end = static_cast<Index>(std::min(rows, (cell + 1) * rows_per_cell));
        const auto for_each_touched = [&](auto&& use) {
            for (Index i = begin; i < end; ++i) {
                use(taken[static_cast<std::size_t>(i)]);
                for (const Neighbor neighbor : system.pairs.row(i))
                    use(taken[static_cast<std::size_t>(neighbor.particle())]);
            }
        };
        Colors all{};
        for_each_touched([&](const Colors& colors) {
            for (std::size_t w = 0; w < all.size(); ++w) all[w] |= colors[w];
        });
        std::size_t word = 0;
        while (word < all.size() && all[word] == ~std::uint64_t{0}) ++word;
        require(word < all.size(), "colors: more than {}; use smaller cells", most_colors);
        const auto bit = static_cast<std::size_t>(std::countr_one(all[word]));
        for_each_touched([&](Colors& colors) { colors[word] |= std::uint64_t{1} << bit; });
        const std::size_t color = 64 * word + bit;
        if (cells_of_color_.size() <= color) cells_of_color_.resize(color + 1);
        cells_of_color_[color].push_back(cell);
    }
}

PairSums ColoredCells::forces(const PairSystem& system, std::vector<Load>& loads) const {
    const PairLaw law(system);
    const Count rows = system.pairs.particle_count();
    std::vector<PairSums> parts(static_cast<std::size_t>(block_count(rows, rows_per_cell)));
    for_each_block(rows, 4096, [&](Count, Count begin, Count end) {
        std::fill(loads.begin() + begin, loads.begin() + end, Load{Vec3::Zero(), 0.0});
    });
    for (const auto& cells : cells_of_color_) {
        for_each_task(static_cast<Count>(cells.size()), [&](Count task) {
            const Count cell = cells[static_cast<std::size_t>(task)];
            PairSums sums;
            const Count end = std::min(rows, (cell + 1) * rows_per_cell);
            for (auto i = static_cast<Index>(cell * rows_per_cell); i < end; ++i) {
                Double4 own{};
                for (const Neighbor neighbor : system.pairs.row(i)) {
                    const Double4 load = law(i, neighbor, 1.0, sums);
                    if (load[3] == 0.0) continue;
                    own += load;
                    add_to(loads[static_cast<std::size_t>(neighbor.particle())], reaction(load));
                }
                add_to(loads[static_cast<std::size_t>(i)], own);
            }
            parts[static_cast<std::size_t>(cell)] = sums;
        });
    }
    return sum_in_order(parts);
}

StoredPairForces::StoredPairForces(const PairSystem& system) {
    const NeighborList& pairs = system.pairs;
    std::vector<Index> second(pairs.neighbors.size());
    for (std::size_t p = 0; p < second.size(); ++p) second[p] = pairs.neighbors[p].particle();
    std::vector<Index> begin;
    std::vector<Index> order(second.size());
    counting_sort(second, pairs.particle_count(), begin, order);
    listed_begin_.assign(begin.begin(), begin.end());
    listed_.assign(order.begin(), order.end());
    pair_loads_.resize(second.size());
}

PairSums StoredPairForces::forces(const PairSystem& system, std::vector<Load>& loads) {
    const PairLaw law(system);
    const Count rows = system.pairs.particle_count();
    std::vector<PairSums> parts(static_cast<std::size_t>(block_count(rows, rows_per_cell)));
    for_each_block(rows, rows_per_cell, [&](Count block, Count begin, Count end) {
        PairSums sums;
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
            auto pair =
                static_cast<std::size_t>(system.pairs.row_begin[static_cast<std::size_t>(i)]);
            for (const Neighbor neighbor : system.pairs.row(i))
                store4(law(i, neighbor, 1.0, sums), pair_loads_[pair++]);
        }
        parts[static_cast<std::size_t>(block)] = sums;
    });
    for_each_block(rows, rows_per_cell, [&](Count, Count begin, Count end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            Double4 own{};
            for (Count p = system.pairs.row_begin[i]; p < system.pairs.row_begin[i + 1]; ++p)
                own += load4(pair_loads_[static_cast<std::size_t>(p)]);
            for (Count k = listed_begin_[i]; k < listed_begin_[i + 1]; ++k)
                own += reaction(load4(pair_loads_[listed_[static_cast<std::size_t>(k)]]));
            store4(own, loads[i]);
        }
    });
    return sum_in_order(parts);
}

FullList::FullList(const PairSystem& system) {
    const NeighborList& half = system.pairs;
    const auto rows = static_cast<std::size_t>(half.particle_count());
    full_.row_begin.assign(rows + 1, 0);
    const auto for_each_side = [&](auto&& use) {
        for (Index i = 0; i < half.particle_count(); ++i)
            for (const Neighbor neighbor : half.row(i)) {
                use(i, neighbor);
                use(neighbor.particle(), Neighbor(i, image_count - 1 - neighbor.image()));
            }
    };
    for_each_side([&](Index i, Neighbor) { ++full_.row_begin[static_cast<std::size_t>(i)]; });
    full_.neighbors.resize(static_cast<std::size_t>(exclusive_scan(full_.row_begin)));
    std::vector<Count> next = full_.row_begin;
    for_each_side([&](Index i, Neighbor neighbor) {
        full_.neighbors[static_cast<std::size_t>(next[static_cast<std::size_t>(i)]++)] = neighbor;
    });
}

PairSums FullList::forces(const PairSystem& system, std::vector<Load>& loads) const {
    const PairLaw law(system);
    const Count rows = full_.particle_count();
    return sum_blocks(rows, rows_per_cell, PairSums{}, [&](Count begin, Count end) {
        PairSums sums;
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
            Double4 own{};
            for (const Neighbor neighbor : full_.row(i)) own += law(i, neighbor, 0.5, sums);
            store4(own, loads[static_cast<std::size_t>(i)]);
        }
        return sums;
    });
}

}  // namespace jam::bench
