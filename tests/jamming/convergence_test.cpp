// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/convergence.h"

#include "analysis/stability.h"
#include "support/packings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace jam {
namespace {

/// Index of the particle whose center is nearest to `point`.
Index nearest(const Packing& packing, const Vec3& point) {
    const auto distance = [&](const Vec3& position) { return (position - point).norm(); };
    return static_cast<Index>(std::ranges::min_element(packing.positions, {}, distance) -
                              packing.positions.begin());
}

void add(Packing& packing, const Vec3& position, double diameter) {
    packing.positions.push_back(position);
    packing.diameters.push_back(diameter);
    packing.ids.push_back(packing.size());
}

constexpr double lattice_constant = 1.3859;  // spheres of diameter 1 overlap by 2 %
constexpr double diameter_of_filler = 0.4;
constexpr double diameter_of_pole = 0.97;

/// A close crystal with one octahedral hole filled: the sphere in it is squeezed by four neighbors
/// in the plane z = const and does not reach the two above and below, which are a little smaller.
struct FilledHole {
    Packing packing;
    Vec3 center;
    Vec3 above;   ///< center of the smaller sphere over the hole
    Vec3 beside;  ///< of the one that squeezes along x
};

FilledHole filled_hole() {
    const double half = lattice_constant / 2.0;
    FilledHole hole;
    hole.packing = test::face_centered_cubic(3, lattice_constant, 1.0);
    hole.center = Vec3::Constant(3.0 * half);
    hole.above = hole.center + Vec3(0.0, 0.0, half);
    hole.beside = hole.center + Vec3(half, 0.0, 0.0);
    const Vec3 below = hole.center - Vec3(0.0, 0.0, half);
    for (const Vec3& pole : {hole.above, below})
        hole.packing.diameters[nearest(hole.packing, pole)] = diameter_of_pole;
    add(hole.packing, hole.center, diameter_of_filler);
    return hole;
}

/// A small sphere that just touches the one in the hole, one above it and one beside it, all four
/// in one plane: by Newton's method for the circle between three circles (Apollonius).
void add_supporter(FilledHole& hole) {
    constexpr double overlap = 1e-9;
    const std::array<Vec3, 3> centers = {hole.center, hole.above, hole.beside};
    const std::array<double, 3> radii = {diameter_of_filler / 2.0, diameter_of_pole / 2.0, 0.5};
    Vec3 found(0.3, 0.3, 0.0);  // x and z from the center of the hole, and the radius
    const auto at = [&] { return Vec3(hole.center + Vec3(found[0], 0.0, found[1])); };
    for (int iteration = 0; iteration < 20; ++iteration) {
        Mat3 slopes;
        Vec3 error;
        for (int i = 0; i < 3; ++i) {
            const Vec3 apart = at() - centers[i];
            error[i] = apart.norm() - radii[i] - found[2] + overlap;
            slopes.row(i) << apart.x() / apart.norm(), apart.z() / apart.norm(), -1.0;
        }
        found -= slopes.inverse() * error;
    }
    add(hole.packing, at(), 2.0 * found[2]);
}

Measurement measurement_of(const Packing& packing) {
    Measurement measurement;
    measurement.packing = packing;
    measurement.network = find_force_network(packing);
    measurement.statistics = packing_statistics(packing, measurement.network);
    return measurement;
}

/// What the quasi-static verdict says of stability, forces and pressure taken as they are.
Criterion stability_of(const Packing& packing) {
    const Measurement measurement = measurement_of(packing);
    Scene scene;
    scene.protocol.pressure = measurement.statistics.pressure;
    scene.stop.cundall = 1.0;
    const Verdict verdict = judge(measurement, JamState{}, scene);
    return verdict.criteria.back();
}

TEST(Convergence, AnUnsupportedSphereAboutToBuckleIsNoStablePacking) {
    const Criterion stability = stability_of(filled_hole().packing);
    EXPECT_EQ(stability.name, "instability");
    EXPECT_FALSE(stability.holds);
    EXPECT_GT(stability.value, 0.01);
}

TEST(Convergence, HowSmallRattlersAreSaysNothingOfStability) {
    FilledHole hole = filled_hole();
    const double without = stability_of(hole.packing).value;
    const Vec3 empty_hole = hole.center + Vec3(lattice_constant, 0.0, 0.0);
    add(hole.packing, empty_hole, 0.01);
    EXPECT_NEAR(stability_of(hole.packing).value / without, 1.0, 1e-6);
}

TEST(Convergence, AThreeContactSphereMayBeWhatSomethingLeansOn) {
    FilledHole hole = filled_hole();
    add_supporter(hole);
    const Count supporter = hole.packing.size() - 1;
    const ForceNetwork whole = find_force_network(hole.packing);
    const ForceNetwork without = find_force_network(hole.packing, 4);
    ASSERT_FALSE(whole.rattlers.is_rattler[supporter]);
    ASSERT_TRUE(without.rattlers.is_rattler[supporter]);
    ASSERT_FALSE(without.rattlers.is_rattler[supporter - 1]);

    const Criterion stability = stability_of(hole.packing);
    EXPECT_EQ(stability.name, "instability");
    EXPECT_TRUE(stability.holds) << stability.value;
}

TEST(Convergence, TwoThatPushEachOtherAlongAreMissingNoContact) {
    // In each hole of a simple cubic crystal two small spheres that touch each other and two
    // neighbors each: three contacts for a sphere, five for six freedoms.
    const double place = (0.5 + std::sqrt(0.5)) / (2.0 + std::sqrt(2.0));
    const double radius = std::sqrt(0.5) * (1.0 - 2.0 * place) + 1e-9;
    Packing packing = test::simple_cubic(3, 1.0, 1.0 + 1e-9);
    const Vec3 corner = packing.positions.front();
    add(packing, corner + Vec3(0.5, place, place), 2.0 * radius);
    add(packing, corner + Vec3(0.5, 1.0 - place, 1.0 - place), 2.0 * radius);

    const PackingStatistics all = packing_statistics(packing, find_force_network(packing));
    ASSERT_EQ(all.contact_count_nr, 3 * 27 + 5);
    ASSERT_EQ(all.rattler_count, 0);
    EXPECT_EQ(excess_contact_count_of_held(packing), all.excess_contact_count() + 1);
}

}  // namespace
}  // namespace jam
