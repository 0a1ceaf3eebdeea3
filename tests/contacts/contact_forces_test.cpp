// SPDX-License-Identifier: BSD-3-Clause
#include "contacts/contact_forces.h"

#include "contacts/elastic_laws.h"
#include "core/state_hash.h"
#include "neighbors/brute_force_neighbors.h"
#include "neighbors/find_neighbors.h"
#include "support/random_packings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

constexpr InteractionReach wide{0.02, 0.05};

/// A tilted, overlapping packing with its tiles.
struct Sample {
    PeriodicCell cell;
    Particles particles;
    ContactTiles tiles;
};

Sample make_sample(std::uint64_t seed, int count, double size_ratio,
                   const InteractionReach& reach = wide, double shrunk_to = 1.0) {
    test::RandomPacking packing =
        test::random_packing(seed, {.count = count, .size_ratio = size_ratio, .least_width = 1.3});
    for (Sphere& sphere : packing.particles.spheres) sphere.diameter *= shrunk_to;
    GridHierarchy hierarchy(geometric_collections(test::diameters_of(packing.particles)));
    hierarchy.group(packing.particles);
    NeighborScratch scratch;
    NeighborList candidates;
    find_candidates(hierarchy, packing.cell, reach, packing.particles, scratch, candidates);
    Sample sample{packing.cell, packing.particles, {}};
    TileScratch tile_scratch;
    make_contact_tiles(candidates, sample.cell, reach, sample.particles, tile_scratch,
                       sample.tiles);
    return sample;
}

ContactSums evaluate(Sample& sample, const Material& material, const ContactFlow& flow = {}) {
    ForceScratch scratch;
    auto& loads = sample.particles.loads;
    loads.assign(loads.size(), Load{Vec3::Zero(), 0.0});
    const ContactSums sums =
        contact_forces(sample.cell, material, flow, sample.tiles, sample.particles, loads, scratch);
    add_halo_loads(sample.tiles, scratch.slots, loads);
    return sums;
}

/// Loads and sums by trying all pairs, straight from the equation.
ContactSums by_brute_force(const Sample& sample, const Material& material, const ContactFlow& flow,
                           std::vector<Load>& loads) {
    const Particles& particles = sample.particles;
    loads.assign(particles.spheres.size(), Load{Vec3::Zero(), 0.0});
    ContactSums sums;
    for (const NearPair& pair : brute_force_neighbors(sample.cell, particles.spheres)) {
        const auto i = static_cast<std::size_t>(pair.first);
        const auto j = static_cast<std::size_t>(pair.second);
        const Vec3 r =
            sample.cell.cartesian(wrapped(particles.spheres[i].center) -
                                  wrapped(particles.spheres[j].center) - pair.image.cast<double>());
        const double diameter_i = particles.spheres[i].diameter;
        const double diameter_j = particles.spheres[j].diameter;
        const double overlap = 0.5 * (diameter_i + diameter_j) - r.norm();
        if (overlap <= 0.0) continue;
        const Vec3 n = r.normalized();
        const double elastic = with_elastic_law(
            material, [&](const auto& law) { return law.force(overlap, diameter_i, diameter_j); });
        double force = elastic;
        if (flow.damped) {
            const Motion& a = particles.motions[i];
            const Motion& b = particles.motions[j];
            const double speed = n.dot(a.velocity - b.velocity + flow.velocity_gradient * r);
            force = std::max(
                0.0, elastic - a.mass * b.mass / (a.mass + b.mass) * material.damping * speed);
        }
        loads[i].force += force * n;
        loads[j].force -= force * n;
        loads[i].contacts += 1.0;
        loads[j].contacts += 1.0;
        sums.virial += force * n * r.transpose();
        sums.elastic_virial += elastic * n * r.transpose();
        sums.energy += with_elastic_law(
            material, [&](const auto& law) { return law.energy(overlap, diameter_i, diameter_j); });
        sums.force_magnitudes += force;
        ++sums.contacts;
    }
    return sums;
}

Mat3 some_gradient() {
    Mat3 gradient;
    gradient << 0.02, -0.03, 0.01, 0.0, -0.05, 0.04, 0.0, 0.0, 0.03;
    return gradient;
}

TEST(ContactForces, EqualTheSumOverAllPairs) {
    for (const ContactLaw law : {ContactLaw::hooke, ContactLaw::hertz}) {
        for (const bool damped : {false, true}) {
            Sample sample = make_sample(12, 3000, 8.0);
            const Material material{.law = law, .stiffness = 1.7, .damping = 0.8};
            const ContactFlow flow{.damped = damped, .velocity_gradient = some_gradient()};
            std::vector<Load> loads;
            const ContactSums expected = by_brute_force(sample, material, flow, loads);
            const ContactSums sums = evaluate(sample, material, flow);
            EXPECT_EQ(sums.contacts, expected.contacts);
            EXPECT_GT(sums.contacts, 3000);
            EXPECT_NEAR(sums.energy, expected.energy, 1e-12 * expected.energy);
            EXPECT_NEAR(sums.force_magnitudes, expected.force_magnitudes,
                        1e-12 * expected.force_magnitudes);
            EXPECT_LT((sums.virial - expected.virial).norm(), 1e-12 * expected.virial.norm());
            EXPECT_LT((sums.elastic_virial - expected.elastic_virial).norm(),
                      1e-12 * expected.virial.norm());
            for (std::size_t i = 0; i < loads.size(); ++i) {
                EXPECT_EQ(sample.particles.loads[i].contacts, loads[i].contacts);
                EXPECT_LT((sample.particles.loads[i].force - loads[i].force).norm(),
                          1e-11 * (1.0 + loads[i].force.norm()));
            }
        }
    }
}

TEST(ContactForces, AddUpToNothing) {
    Sample sample = make_sample(13, 2000, 5.0);
    const ContactSums sums =
        evaluate(sample, {}, {.damped = true, .velocity_gradient = some_gradient()});
    Vec3 total = Vec3::Zero();
    for (const Load& load : sample.particles.loads) total += load.force;
    EXPECT_GT(sums.force_magnitudes, 100.0);
    EXPECT_LT(total.norm(), 1e-12 * sums.force_magnitudes);
}

TEST(ContactForces, AreMinusTheDerivativeOfTheEnergy) {
    for (const ContactLaw law : {ContactLaw::hooke, ContactLaw::hertz}) {
        Sample sample = make_sample(14, 400, 4.0);
        const Material material{.law = law, .stiffness = 2.0};
        evaluate(sample, material);
        const std::vector<Load> loads = sample.particles.loads;
        int compared = 0;
        for (std::size_t i = 0; i < loads.size(); i += 37) {
            for (int k = 0; k < 3; ++k) {
                constexpr double step = 1e-6;
                const Vec3 before = sample.particles.spheres[i].center;
                const Vec3 moved = sample.cell.fractional(step * Vec3::Unit(k));
                sample.particles.spheres[i].center = before + moved;
                const double above = evaluate(sample, material).energy;
                sample.particles.spheres[i].center = before - moved;
                const double below = evaluate(sample, material).energy;
                sample.particles.spheres[i].center = before;
                const double expected = loads[i].force[k];
                EXPECT_NEAR(-(above - below) / (2.0 * step), expected,
                            1e-6 * (1.0 + loads[i].force.norm()));
                if (std::abs(expected) > 1e-3) ++compared;
            }
        }
        EXPECT_GT(compared, 15);
    }
}

TEST(ContactForces, PressureIsMinusTheDerivativeOfTheEnergyWithStrain) {
    for (const ContactLaw law : {ContactLaw::hooke, ContactLaw::hertz}) {
        Sample sample = make_sample(15, 500, 4.0);
        const Material material{.law = law};
        const PeriodicCell cell = sample.cell;
        EXPECT_FALSE(cell.is_orthogonal());
        const Mat3 pressure = evaluate(sample, material).virial / cell.volume();
        for (int row = 0; row < 3; ++row) {
            for (int column = row; column < 3; ++column) {
                constexpr double step = 1e-6;
                const auto energy_at = [&](double strain) {
                    Mat3 deformation = Mat3::Identity();
                    deformation(row, column) += strain;
                    sample.cell = PeriodicCell(Mat3(deformation * cell.matrix()));
                    return evaluate(sample, material).energy;
                };
                const double slope = (energy_at(step) - energy_at(-step)) / (2.0 * step);
                EXPECT_NEAR(-slope / cell.volume(), pressure(row, column), 1e-7 * pressure.norm());
                EXPECT_GT(std::abs(pressure(row, column)), 1e-5 * pressure.norm());
                EXPECT_NEAR(pressure(row, column), pressure(column, row), 1e-13 * pressure.norm());
            }
        }
    }
}

TEST(ContactForces, DoNotChangeWhenEverythingIsShiftedByAnImage) {
    Sample sample = make_sample(16, 600, 3.0);
    evaluate(sample, {});
    const std::vector<Load> loads = sample.particles.loads;
    const Vec3 shift = sample.cell.fractional({0.3, -0.2, 0.7});
    for (Sphere& sphere : sample.particles.spheres) sphere.center += shift;
    evaluate(sample, {});
    for (std::size_t i = 0; i < loads.size(); ++i)
        EXPECT_LT((sample.particles.loads[i].force - loads[i].force).norm(), 1e-12);
}

TEST(ContactForces, NeverAttract) {
    // Two spheres that overlap little and separate fast: damping alone would pull them together.
    Sample sample;
    sample.cell = PeriodicCell::cubic(10.0);
    sample.particles.spheres = {{Vec3(0.5, 0.5, 0.5), 1.0}, {Vec3(0.599, 0.5, 0.5), 1.0}};
    sample.particles.motions = {{Vec3(-1.0, 0.0, 0.0), 1.0}, {Vec3(1.0, 0.0, 0.0), 1.0}};
    sample.particles.loads.resize(2);
    sample.particles.ids = {0, 1};
    const NeighborList candidates{{0, 1, 1}, {Neighbor(1, home_image)}};
    TileScratch scratch;
    make_contact_tiles(candidates, sample.cell, {0.0, 0.1}, sample.particles, scratch,
                       sample.tiles);
    ContactSums sums = evaluate(sample, {}, {.damped = true});
    EXPECT_EQ(sums.contacts, 1);
    EXPECT_EQ(sums.force_magnitudes, 0.0);
    // F = k delta - M_eff gamma v_n with v_n = -2, M_eff = 1/2.
    std::swap(sample.particles.motions[0], sample.particles.motions[1]);
    sums = evaluate(sample, {}, {.damped = true});
    EXPECT_NEAR(sums.force_magnitudes, 0.01 + 0.5 * 0.5 * 2.0, 1e-12);
}

TEST(ContactForces, CoincidentCentersGiveNoNumbersThatAreNone) {
    Sample sample = make_sample(17, 50, 2.0);
    for (Sphere& sphere : sample.particles.spheres) sphere.center = Vec3::Constant(0.25);
    EXPECT_TRUE(std::isfinite(evaluate(sample, {}, {.damped = true}).virial.sum()));
    for (const Load& load : sample.particles.loads) EXPECT_TRUE(load.force.allFinite());
}

/// Those that touch another, by particle.
std::vector<char> touching(const Sample& sample) {
    std::vector<char> touches;
    for (const Load& load : sample.particles.loads) touches.push_back(load.contacts != 0.0);
    return touches;
}

/// One in so many is stirred at each step; counts how often so few are that their tiles are looked
/// for.
void hold_live_tiles_against_whole_ones(std::size_t one_in, double way, int& looked_for) {
    looked_for = 0;
    Sample sample = make_sample(29, 4000, 3.0, {.skin = 0.3}, 0.5);
    Particles& particles = sample.particles;
    std::vector<char> stirred(particles.spheres.size(), false);
    ForceScratch live;
    begin_live_tiles(sample.tiles, live);
    std::vector<Load> loads(particles.spheres.size(), Load{Vec3::Zero(), 0.0});
    // Ever more are stirred, and go a little way.
    Count left_out = 0;
    for (int step = 0; step < 40; ++step) {
        std::vector<Index> newly_stirred;
        const auto stir = [&](std::size_t i) {
            if (!std::exchange(stirred[i], true)) newly_stirred.push_back(static_cast<Index>(i));
        };
        for (std::size_t i = 0; i < particles.spheres.size(); ++i) {
            if (i % one_in == static_cast<std::size_t>(step)) stir(i);
            if (stirred[i]) particles.spheres[i].center += way * Vec3(2.0, -1.0, 1.0);
        }
        looked_for += newly_stirred.size() <= sample.tiles.tiles.size();
        stir_live_tiles(sample.tiles, newly_stirred, live);
        const ContactSums expected = evaluate(sample, {});
        const ContactSums sums =
            live_contact_forces(sample.cell, {}, sample.tiles, stirred, particles, loads, live);
        add_halo_loads(sample.tiles, live.slots, loads);
        ASSERT_EQ(sums.contacts, expected.contacts);
        ASSERT_EQ(sums.energy, expected.energy);
        ASSERT_EQ(sums.virial, expected.virial);
        std::vector<char> woken = stirred;
        newly_stirred.clear();
        for (const std::vector<Index>& some : live.woken_of_tile) {
            for (const Index i : some)
                if (!std::exchange(woken[static_cast<std::size_t>(i)], true))
                    newly_stirred.push_back(i);
        }
        stir_live_tiles(sample.tiles, newly_stirred, live);
        const std::vector<char> touches = touching(sample);
        for (std::size_t i = 0; i < loads.size(); ++i) {
            ASSERT_EQ(loads[i].force, particles.loads[i].force) << "step " << step;
            ASSERT_EQ(loads[i].contacts, particles.loads[i].contacts);
            ASSERT_EQ(woken[i], stirred[i] | touches[i]);
        }
        stirred = woken;
        left_out += sample.tiles.pair_count();
        for (const LiveTile& tile : live.live_tiles)
            left_out -= static_cast<Count>(tile.pairs.size());
    }
    EXPECT_GT(left_out, 1000) << "nothing was tested";
}

TEST(ContactForces, LiveTilesGiveTheSameBitsAndSayWhoIsWoken) {
    int looked_for = 0;
    hold_live_tiles_against_whole_ones(97, 1e-5, looked_for);
    EXPECT_EQ(looked_for, 0);
    hold_live_tiles_against_whole_ones(1999, 1e-4, looked_for);
    EXPECT_GT(looked_for, 20);
}

TEST(ContactForces, SameBitsForAnyThreadCount) {
    const auto bits_with = [](int threads) {
        return run_with_threads(threads, [] {
            Sample sample = make_sample(18, 20000, 20.0);
            const ContactSums sums =
                evaluate(sample, {}, {.damped = true, .velocity_gradient = some_gradient()});
            const std::uint64_t hash = state_hash<Load>(sample.particles.loads);
            return state_hash(std::span<const double>(sums.virial.data(), 9), hash);
        });
    };
    const std::uint64_t alone = bits_with(1);
    for (const int threads : {2, 3, 5, 8, 16}) EXPECT_EQ(bits_with(threads), alone) << threads;
}

}  // namespace
}  // namespace jam
