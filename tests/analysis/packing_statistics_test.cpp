// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/packing_statistics.h"

#include "analysis/coordination.h"
#include "analysis/static_stress.h"
#include "core/check.h"
#include "core/parallel.h"
#include "support/packings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace jam {
namespace {

using namespace test;
using std::numbers::pi;

PackingStatistics statistics_of(const Packing& packing, int threshold = 3) {
    return packing_statistics(packing, find_force_network(packing, threshold));
}

void expect_near(const Mat3& a, const Mat3& b, double tolerance) {
    EXPECT_NEAR((a - b).cwiseAbs().maxCoeff(), 0.0, tolerance) << a << "\n\n" << b;
}

/// Every sphere of a crystal has `neighbors` contacts with centers `apart`, in directions that
/// average to isotropy: P = (N Z / 2) f r / (3 V).
void expect_crystal(const Packing& packing, int neighbors, double apart) {
    const double diameter = packing.diameters[0];
    const auto count = static_cast<double>(packing.size());
    const PackingStatistics statistics = statistics_of(packing);
    EXPECT_EQ(statistics.contact_count, packing.size() * neighbors / 2);
    EXPECT_DOUBLE_EQ(statistics.coordination, neighbors);
    EXPECT_DOUBLE_EQ(statistics.coordination_nr, neighbors);
    EXPECT_EQ(statistics.rattler_count, 0);
    const double volume = packing.cell.volume();
    EXPECT_NEAR(statistics.volume_fraction, count * pi / 6.0 * std::pow(diameter, 3) / volume,
                1e-14);
    const double pressure = count * neighbors / 2.0 * (diameter - apart) * apart / (3.0 * volume);
    expect_near(statistics.pressure, Mat3::Identity() * pressure, 1e-13);
    EXPECT_NEAR(statistics.cundall, 0.0, 1e-12);
    EXPECT_NEAR(statistics.largest_overlap, (diameter - apart) / diameter, 1e-13);
    EXPECT_NEAR(statistics.mean_overlap, (diameter - apart) / diameter, 1e-13);
}

TEST(PackingStatistics, SimpleCubicCrystal) {
    expect_crystal(simple_cubic(4, 0.99, 1.0), 6, 0.99);
    expect_crystal(simple_cubic(2, 1.9, 2.0), 6, 1.9);  // each pair through two images
}

TEST(PackingStatistics, FaceCenteredCubicCrystal) {
    const double apart = 1.0 / std::numbers::sqrt2;
    expect_crystal(face_centered_cubic(3, 1.0, 0.72), 12, apart);
    expect_crystal(face_centered_cubic(1, 1.0, 0.72), 12, apart);
}

TEST(PackingStatistics, TwoSpheresByHand) {
    // Overlap 0.1 along (0.8, 0.6, 0), 1.5 apart; both are rattlers.
    const Mat3 edges = Vec3(10.0, 8.0, 5.0).asDiagonal();
    Packing packing = make_packing(edges, {{2.0, 3.0, 2.0}, {3.2, 3.9, 2.0}}, {1.0, 2.2});
    packing.velocities = {{0.3, 0.0, 0.4}, {0.0, 0.0, -0.1}};
    packing.material.density = 2.0;
    const PackingStatistics statistics = statistics_of(packing);
    EXPECT_EQ(statistics.particle_count, 2);
    EXPECT_DOUBLE_EQ(statistics.size_ratio, 2.2);
    EXPECT_EQ(statistics.contact_count, 1);
    EXPECT_EQ(statistics.rattler_count, 2);
    EXPECT_DOUBLE_EQ(statistics.rattler_fraction, 1.0);
    EXPECT_DOUBLE_EQ(statistics.coordination, 1.0);
    EXPECT_DOUBLE_EQ(statistics.coordination_nr, 0.0);
    EXPECT_DOUBLE_EQ(statistics.volume_fraction_nr, 0.0);
    EXPECT_NEAR(statistics.volume_fraction, pi / 6.0 * (1.0 + std::pow(2.2, 3)) / 400.0, 1e-15);
    const Vec3 normal(0.8, 0.6, 0.0);
    expect_near(statistics.pressure, 0.1 * 1.5 / 400.0 * normal * normal.transpose(), 1e-16);
    EXPECT_NEAR(statistics.cundall, 2.0, 1e-13);
    EXPECT_NEAR(statistics.largest_overlap, 0.1 / 1.0, 1e-14);
    const double energy = pi / 6.0 * (0.25 + std::pow(2.2, 3) * 0.01);  // density 2 times 1/2
    EXPECT_NEAR(statistics.kinetic_energy_per_particle, energy / 2.0, 1e-15);
    EXPECT_EQ(statistics.cell, edges);
}

TEST(PackingStatistics, RowsOfTheCellAreItsEdges) {
    const Mat3 edges = random_edges(3.0, 1);
    const PackingStatistics statistics = statistics_of(make_packing(edges, {{0, 0, 0}}, {1.0}));
    EXPECT_EQ(statistics.cell.row(1).transpose(), edges.col(1));
    EXPECT_EQ(statistics.cell(2, 1), edges(1, 2));
}

TEST(PackingStatistics, WhatHasNoContactsHasNoCundall) {
    const PackingStatistics statistics =
        statistics_of(make_packing(Mat3::Identity() * 5.0, {{0, 0, 0}, {2, 2, 2}}, {1.0, 1.0}));
    EXPECT_TRUE(std::isnan(statistics.cundall));
    EXPECT_EQ(statistics.pressure, Mat3::Zero().eval());
    EXPECT_EQ(statistics.isostatic_contact_count, 0);
}

TEST(PackingStatistics, BackboneLeavesRattlersOut) {
    // Layers of a square lattice, and one small sphere that touches a single sphere of them.
    Packing packing = simple_cubic(2, 0.95, 1.0);
    packing.cell = PeriodicCell(Vec3(1.9, 1.9, 3.0).asDiagonal());
    packing.positions.emplace_back(0.0, 0.0, 1.65);
    packing.diameters.push_back(0.5);
    packing.ids.push_back(9);
    const PackingStatistics statistics = statistics_of(packing);
    EXPECT_EQ(statistics.rattler_count, 1);
    EXPECT_EQ(statistics.contact_count, 8 * 5 / 2 + 1);
    EXPECT_EQ(statistics.contact_count_nr, 8 * 5 / 2);
    EXPECT_DOUBLE_EQ(statistics.coordination_nr, 5.0);
    EXPECT_NEAR(statistics.volume_fraction - statistics.volume_fraction_nr,
                pi / 6.0 * 0.125 / packing.cell.volume(), 1e-14);
}

TEST(StaticPressure, IsMinusTheDerivativeOfTheEnergy) {
    // U(h) by straining the cell, all six components, in a tilted cell with images.
    const Mat3 edges = random_edges(5.0, 7);
    const Packing packing = random_spheres(edges, 150, 3.0, 7);
    const auto energy = [&](const Mat3& strain) {
        Packing strained = packing;
        const Mat3 deformation = Mat3::Identity() + strain;
        strained.cell = PeriodicCell(deformation * edges);
        for (Vec3& position : strained.positions) position = deformation * position;
        double sum = 0.0;
        for (const Contact& contact : find_contacts(strained))
            sum += 0.5 * contact.overlap * contact.overlap;
        return sum;
    };
    const Mat3 pressure = static_pressure(packing, find_contacts(packing));
    constexpr double step = 1e-6;
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b) {
            Mat3 strain = Mat3::Zero();
            strain(a, b) = step;
            const double slope = (energy(strain) - energy(-strain)) / (2.0 * step);
            ASSERT_GT(std::abs(pressure(a, b)), 1e-4);
            EXPECT_NEAR(pressure(a, b), -slope / packing.cell.volume(),
                        1e-5 * std::abs(pressure(a, b)));
        }
    }
    expect_near(pressure, pressure.transpose(), 1e-15);
}

TEST(PackingStatistics, TheSameHoweverThePackingIsTold) {
    const Mat3 edges = random_edges(13.0, 8);
    Packing packing = random_spheres(edges, 250, 4.0, 8);
    packing.velocities.assign(250, Vec3(1e-3, 0.0, 2e-3));
    Packing retold = relabelled(packing, shuffled(250, 8));
    Mat3 other = edges;
    other.col(2) += edges.col(1) - 2.0 * edges.col(0);
    retold.cell = PeriodicCell(other);
    retold = moved(retold, [&](const Vec3& x) -> Vec3 {
        return x + edges * Vec3(3, -1, 2) + Vec3(0.1, 0.2, -0.3);
    });
    const PackingStatistics a = statistics_of(packing);
    const PackingStatistics b = statistics_of(retold);
    ASSERT_GT(a.rattler_count, 0);
    EXPECT_EQ(a.contact_count, b.contact_count);
    EXPECT_EQ(a.contact_count_nr, b.contact_count_nr);
    EXPECT_EQ(a.rattler_count, b.rattler_count);
    EXPECT_NEAR(a.volume_fraction_nr, b.volume_fraction_nr, 1e-13);
    EXPECT_NEAR(a.cundall, b.cundall, 1e-12);
    EXPECT_NEAR(a.cundall_nr, b.cundall_nr, 1e-12);
    EXPECT_NEAR(a.kinetic_energy_per_particle, b.kinetic_energy_per_particle, 1e-18);
    expect_near(a.pressure, b.pressure, 1e-13);
}

TEST(PackingStatistics, TheSameBitsForAnyThreadCount) {
    const Packing packing = random_spheres(random_edges(20.0, 9), 9000, 4.0, 9);
    const auto measure = [&] { return statistics_of(packing); };
    const PackingStatistics reference = run_with_threads(1, measure);
    for (const int threads : {2, 3, 8}) {
        const PackingStatistics statistics = run_with_threads(threads, measure);
        EXPECT_EQ(statistics.pressure, reference.pressure);
        EXPECT_EQ(statistics.cundall, reference.cundall);
        EXPECT_EQ(statistics.volume_fraction, reference.volume_fraction);
        EXPECT_EQ(statistics.mean_overlap, reference.mean_overlap);
    }
}

TEST(IsostaticContactCount, CountsWhatTheCellLeavesFree) {
    EXPECT_EQ(isostatic_contact_count(100, 6), 303);
    EXPECT_EQ(isostatic_contact_count(100, 3), 300);
    EXPECT_EQ(isostatic_contact_count(100, 1), 298);
    EXPECT_EQ(isostatic_contact_count(100, 0), 298);  // one state of self-stress: the pressure
    EXPECT_EQ(isostatic_contact_count(0, 6), 0);
    EXPECT_THROW(isostatic_contact_count(100, 7), InputError);
}

TEST(FindForceNetwork, RefusesWhatMeansNothing) {
    const Packing packing = simple_cubic(2, 1.0, 1.01);
    EXPECT_THROW(find_force_network(packing, 0), InputError);
    EXPECT_THROW(find_force_network(packing, 101), InputError);
    EXPECT_THROW(statistics_of(make_packing(Mat3::Identity(), {}, {})), InputError);
}

}  // namespace
}  // namespace jam
