// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/relaxation_metric.h"

#include "analysis/rattlers.h"
#include "contacts/elastic_laws.h"
#include "core/lanes.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jam {

namespace {

constexpr double kept_share = 0.8;  // of the running means at a renewal
constexpr double gap_in_mean_overlaps = 3.0;
constexpr double stiffness_factor = 3.0;
constexpr double held_floor = 0.01;
constexpr double loose_floor = 3.0;

void mix(double kept, const SymmetricBlock& now, SymmetricBlock& mean) {
    const auto into = [kept](double value, double& of) { of = kept * of + (1.0 - kept) * value; };
    into(now.xx, mean.xx);
    into(now.xy, mean.xy);
    into(now.xz, mean.xz);
    into(now.yy, mean.yy);
    into(now.yz, mean.yz);
    into(now.zz, mean.zz);
}

BlockResponse response_of(const SymmetricBlock& k, double floor) {
    const double xx = stiffness_factor * k.xx + floor;
    const double yy = stiffness_factor * k.yy + floor;
    const double zz = stiffness_factor * k.zz + floor;
    const double xy = stiffness_factor * k.xy;
    const double xz = stiffness_factor * k.xz;
    const double yz = stiffness_factor * k.yz;
    const double minor_xx = yy * zz - yz * yz;
    const double minor_xy = xz * yz - xy * zz;
    const double minor_xz = xy * yz - xz * yy;
    const double scale = 1.0 / (xx * minor_xx + xy * minor_xy + xz * minor_xz);
    return {.inverse = {minor_xx * scale, minor_xy * scale, minor_xz * scale,
                        (xx * zz - xz * xz) * scale, (xy * xz - xx * yz) * scale,
                        (xx * yy - xy * xy) * scale},
            .mass = (xx + yy + zz) / 3.0};
}

/// What the contacts of one particle add up to.
struct Surroundings {
    SymmetricBlock block;
    Mat3 cell = Mat3::Zero();
    double contacts = 0.0;

    void add(const Vec3& r, double tangent) {
        const double scale = tangent / r.squaredNorm();
        block.xx += scale * r[0] * r[0];
        block.xy += scale * r[0] * r[1];
        block.xz += scale * r[0] * r[2];
        block.yy += scale * r[1] * r[1];
        block.yz += scale * r[1] * r[2];
        block.zz += scale * r[2] * r[2];
        const Vec3 squares = r.cwiseProduct(r);
        cell += 0.5 * scale * squares * squares.transpose();  // each contact is met twice
        contacts += 1.0;
    }
};

struct StiffnessSums {
    Mat3 cell = Mat3::Zero();
    double stiffness = 0.0;
    double contacts = 0.0;

    StiffnessSums& operator+=(const StiffnessSums& other) {
        cell += other.cell;
        stiffness += other.stiffness;
        contacts += other.contacts;
        return *this;
    }
};

template <typename Law>
Surroundings surroundings_of(Index i, const NeighborList& full, const PeriodicCell& cell,
                             const Law& law, double mean_overlap, const Particles& particles) {
    const Sphere& sphere = particles.spheres[static_cast<std::size_t>(i)];
    const double gap = gap_in_mean_overlaps * mean_overlap;
    Surroundings sum;
    for (const Neighbor neighbor : full.row(i)) {
        const Sphere& other = particles.spheres[static_cast<std::size_t>(neighbor.particle())];
        const ImageShift& shift = image_shifts[neighbor.image()];
        const Vec3 r =
            cell.cartesian(sphere.center - other.center - Vec3(shift.x, shift.y, shift.z));
        const double touching = 0.5 * (sphere.diameter + other.diameter);
        const double squared = r.squaredNorm();
        const double reach = touching + gap;
        if (squared >= reach * reach || squared == 0.0) continue;
        const double overlap = std::max(touching - std::sqrt(squared), mean_overlap);
        sum.add(r, law.tangent(overlap, sphere.diameter, other.diameter));
    }
    return sum;
}

/// Calls body(place, id) for particles, and has what belongs to the ids of those to come brought
/// near: ids lie anywhere in memory.
template <typename Body>
void for_each_id(std::span<const Index> places, const Particles& particles,
                 const std::vector<ParticleStiffness>& by_id, Body&& body) {
    const auto id_of = [&](std::size_t k) {
        return particles.ids[static_cast<std::size_t>(places[k])];
    };
    for_each_expected(
        0, places.size(), [&](std::size_t k) { expect_read(by_id[id_of(k)]); },
        [&](std::size_t k) { body(places[k], id_of(k)); });
}

}  // namespace

NeighborList full_list(const NeighborList& half) {
    const Index count = half.particle_count();
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    NeighborList full;
    full.row_begin.assign(at(count) + 1, 0);
    for (Index i = 0; i < count; ++i) {
        full.row_begin[at(i)] += static_cast<Count>(half.row(i).size());
        for (const Neighbor neighbor : half.row(i)) ++full.row_begin[at(neighbor.particle())];
    }
    exclusive_scan(full.row_begin);
    full.neighbors.resize(static_cast<std::size_t>(full.row_begin.back()));
    std::vector<Count> next(full.row_begin.begin(), full.row_begin.end() - 1);
    const auto add = [&](Index row, Neighbor neighbor) {
        full.neighbors[static_cast<std::size_t>(next[at(row)]++)] = neighbor;
    };
    for (Index i = 0; i < count; ++i) {
        for (const Neighbor neighbor : half.row(i)) {
            add(i, neighbor);
            add(neighbor.particle(), Neighbor(i, image_count - 1 - neighbor.image()));
        }
    }
    return full;
}

void renew_stiffness(const NeighborList& full, const PeriodicCell& cell, const Material& material,
                     double mean_overlap, const Particles& particles, const ActiveParticles& active,
                     ContactStiffness& stiffness) {
    const double kept = stiffness.empty() ? 0.0 : kept_share;
    stiffness.particles.resize(particles.spheres.size());
    const StiffnessSums sums = with_elastic_law(material, [&](const auto& law) {
        return sum_active(active, StiffnessSums{}, [&](Count block) {
            StiffnessSums sum;
            for_each_id(
                active.awake_of_block(block), particles, stiffness.particles,
                [&](Index i, std::size_t id) {
                    const Surroundings now =
                        surroundings_of(i, full, cell, law, mean_overlap, particles);
                    ParticleStiffness& of_particle = stiffness.particles[id];
                    mix(kept, now.block, of_particle.block);
                    of_particle.contacts = now.contacts;
                    sum += {now.cell, now.block.xx + now.block.yy + now.block.zz, now.contacts};
                });
            return sum;
        });
    });
    stiffness.cell = kept * stiffness.cell + (1.0 - kept) * sums.cell;
    const double typical =
        sums.contacts > 0.0 ? sums.stiffness / sums.contacts : material.stiffness;
    stiffness.typical = kept * stiffness.typical + (1.0 - kept) * typical;
}

void forget_metric(const Particles& particles, RelaxationMetric& metric) {
    metric.particles.resize(particles.spheres.size());
    metric.stands.assign(particles.spheres.size(), false);
    metric.set_of_block.clear();
}

void set_metric(const ContactStiffness& stiffness, const Particles& particles,
                const ActiveParticles& active, RelaxationMetric& metric) {
    const double unit = stiffness.typical;
    metric.set_of_block.resize(static_cast<std::size_t>(active.block_count()), 0);
    for_each_block(active.block_count(), 1, [&](Count block, Count, Count) {
        const auto count = static_cast<Count>(active.of_block(block).size());
        if (std::exchange(metric.set_of_block[static_cast<std::size_t>(block)], count) == count)
            return;
        std::vector<Index> missing;
        for (const Index i : active.of_block(block))
            if (!std::exchange(metric.stands[static_cast<std::size_t>(i)], true))
                missing.push_back(i);
        for_each_id(missing, particles, stiffness.particles, [&](Index i, std::size_t id) {
            const ParticleStiffness& of_particle = stiffness.particles[id];
            const bool held = of_particle.contacts >= contacts_that_hold;
            metric.particles[static_cast<std::size_t>(i)] =
                response_of(of_particle.block, unit * (held ? held_floor : loose_floor));
        });
    });
    // Without any contact the cell has no stiffness, and still must not fly away.
    metric.cell_inertia = (stiffness_factor * stiffness.cell).cwiseMax(unit);
}

}  // namespace jam
