// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/hessian.h"

#include "analysis/static_stress.h"
#include "core/random.h"
#include "support/packings.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace jam {
namespace {

constexpr double applied = 0.03;

/// A change of positions and cell.
struct Change {
    std::vector<Vec3> displacement;
    Vec6 strain;
};

Change random_change(Count particle_count, std::uint64_t seed) {
    Change change;
    std::uint32_t draw = 0;
    const auto next = [&] { return uniform(seed, RandomStream::tests, 0, draw++) - 0.5; };
    for (Count i = 0; i < particle_count; ++i)
        change.displacement.emplace_back(Vec3(next(), next(), next()));
    for (int a = 0; a < strain_count; ++a) change.strain[a] = 0.2 * next();
    return change;
}

Mat3 strain_matrix(const Vec6& strain) {
    Mat3 matrix = Mat3::Zero();
    for (int a = 0; a < strain_count; ++a) matrix += strain[a] * unit_strain(a);
    return matrix;
}

/// First derivatives of the enthalpy.
struct Gradient {
    std::vector<Vec3> displacement;
    Vec6 strain;
};

/// After `times` the change, from forces and pressure of the packing that it makes. A strained cell
/// is turned into the restricted form, and what is measured there turned back.
Gradient gradient_after(const Packing& packing, const Change& change, double times) {
    const Mat3 deformation = Mat3::Identity() + times * strain_matrix(change.strain);
    const Mat3 edges = deformation * packing.cell.matrix();
    const Eigen::HouseholderQR<Mat3> qr(edges);
    Mat3 turn = qr.householderQ();
    Mat3 restricted = qr.matrixQR().triangularView<Eigen::Upper>();
    const Mat3 signs = restricted.diagonal().cwiseSign().asDiagonal();
    turn = turn * signs;
    restricted = signs * restricted;

    Packing changed = packing;
    changed.cell = PeriodicCell(restricted);
    for (Count i = 0; i < packing.size(); ++i)
        changed.positions[i] = turn.transpose() * (deformation * packing.positions[i] +
                                                   times * change.displacement[i]);
    const ForceNetwork network = find_force_network(changed);
    const Mat3 back = deformation.inverse();
    Gradient gradient;
    Mat3 moment = Mat3::Zero();  // of the net forces with the displacements: no part of the virial
    for (Count i = 0; i < packing.size(); ++i) {
        const Vec3 force = turn * net_force(network, static_cast<Index>(i));
        gradient.displacement.push_back(-force);
        moment += force * (back * (times * change.displacement[i])).transpose();
    }
    const Mat3 pressure = turn * static_pressure(changed, network.contacts) * turn.transpose();
    const Mat3 work =
        changed.cell.volume() * (applied * Mat3::Identity() - pressure) * back.transpose() + moment;
    for (int a = 0; a < strain_count; ++a)
        gradient.strain[a] = work.cwiseProduct(unit_strain(a)).sum();
    return gradient;
}

Packing crowded(ContactLaw law) {
    Packing packing = test::random_spheres(test::random_edges(9.0, 3), 160, 3.0, 21);
    packing.material.law = law;
    packing.material.stiffness = 1.3;
    return packing;
}

Eigen::VectorXd flat(const std::vector<Vec3>& vectors) {
    Eigen::VectorXd result(3 * vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) result.segment<3>(3 * i) = vectors[i];
    return result;
}

const std::vector<std::uint8_t> none_left_out(160, 0);

TEST(Hessian, TimesAChangeIsTheDifferenceOfForcesAndPressures) {
    for (const ContactLaw law : {ContactLaw::hooke, ContactLaw::hertz}) {
        const Packing packing = crowded(law);
        const ForceNetwork network = find_force_network(packing);
        const EnthalpyHessian hessian = enthalpy_hessian(packing, network, none_left_out, applied);
        const Change change = random_change(packing.size(), 5);
        const Eigen::VectorXd moved = flat(change.displacement);

        const Eigen::VectorXd on_particles =
            hessian.displacement.selfadjointView<Eigen::Lower>() * moved +
            hessian.mixed * change.strain;
        const Vec6 on_cell = hessian.mixed.transpose() * moved + hessian.strain * change.strain;

        constexpr double step = 1e-7;
        const Gradient after = gradient_after(packing, change, step);
        const Gradient before = gradient_after(packing, change, -step);
        const Eigen::VectorXd expected_on_particles =
            (flat(after.displacement) - flat(before.displacement)) / (2.0 * step);
        const Vec6 expected_on_cell = (after.strain - before.strain) / (2.0 * step);

        ASSERT_GT(network.contacts.size(), 300U);
        EXPECT_GT(expected_on_particles.norm(), 1.0);
        EXPECT_LT((on_particles - expected_on_particles).norm(),
                  1e-6 * expected_on_particles.norm());
        EXPECT_GT(expected_on_cell.norm(), 1.0);
        EXPECT_LT((on_cell - expected_on_cell).norm(), 1e-6 * expected_on_cell.norm());
    }
}

TEST(Hessian, IsBlindToTranslations) {
    const Packing packing = crowded(ContactLaw::hertz);
    const ForceNetwork network = find_force_network(packing);
    const EnthalpyHessian hessian = enthalpy_hessian(packing, network, none_left_out, applied);
    const Eigen::VectorXd moved =
        flat(std::vector<Vec3>(static_cast<std::size_t>(packing.size()), Vec3(1.0, -2.0, 0.5)));
    EXPECT_LT((hessian.displacement.selfadjointView<Eigen::Lower>() * moved).norm(), 1e-11);
    EXPECT_LT((hessian.mixed.transpose() * moved).norm(), 1e-11);
}

TEST(Hessian, TakesTheBackboneAlone) {
    Packing packing = crowded(ContactLaw::hooke);
    const ForceNetwork network = find_force_network(packing);
    std::vector<std::uint8_t> left_out(none_left_out);
    for (std::size_t i = 0; i < left_out.size(); i += 3) left_out[i] = 1;
    const EnthalpyHessian hessian = enthalpy_hessian(packing, network, left_out, applied);

    Packing rest = packing;
    rest.positions.clear();
    rest.diameters.clear();
    rest.ids.clear();
    for (const Index i : hessian.particles) {
        EXPECT_EQ(left_out[i], 0);
        rest.positions.push_back(packing.positions[i]);
        rest.diameters.push_back(packing.diameters[i]);
        rest.ids.push_back(packing.ids[i]);
    }
    const std::vector<std::uint8_t> all(rest.positions.size(), 0);
    const EnthalpyHessian expected = enthalpy_hessian(rest, find_force_network(rest), all, applied);
    ASSERT_EQ(hessian.particle_count(), 106);
    EXPECT_LT((hessian.displacement - expected.displacement).norm(), 1e-12);
    EXPECT_LT((hessian.mixed - expected.mixed).norm(), 1e-11);
    EXPECT_LT((hessian.strain - expected.strain).norm(), 1e-10);
}

TEST(Hessian, OfASpringPairByHand) {
    Packing packing =
        test::make_packing(Mat3::Identity() * 10.0, {Vec3(1, 1, 1), Vec3(1.9, 1, 1)}, {1.0, 1.0});
    packing.material.stiffness = 2.0;
    const ForceNetwork network = find_force_network(packing);
    const std::vector<std::uint8_t> both(2, 0);
    const EnthalpyHessian hessian = enthalpy_hessian(packing, network, both, 0.0);
    const double across = 2.0 * 0.1 / 0.9;
    const Eigen::MatrixXd matrix = hessian.displacement;
    EXPECT_NEAR(matrix(0, 0), 2.0, 1e-12);
    EXPECT_NEAR(matrix(1, 1), -across, 1e-12);
    EXPECT_NEAR(matrix(3, 0), -2.0, 1e-12);
    EXPECT_NEAR(matrix(5, 2), across, 1e-12);
    EXPECT_NEAR(hessian.strain(0, 0), 2.0 * 0.9 * 0.9, 1e-12);
    EXPECT_NEAR(hessian.strain(5, 5), -across * 0.45 * 0.45, 1e-12);
    EXPECT_NEAR(enthalpy_hessian(packing, network, both, 0.0, false).displacement.coeff(1, 1), 0.0,
                1e-15);
}

}  // namespace
}  // namespace jam
