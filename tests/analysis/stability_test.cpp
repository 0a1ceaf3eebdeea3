// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/stability.h"

#include "analysis/static_stress.h"
#include "support/packings.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

/// The whole packing, under the pressure that it has.
EnthalpyHessian hessian_of(const Packing& packing, bool prestress = true) {
    const ForceNetwork network = find_force_network(packing);
    const std::vector<std::uint8_t> none_left_out(packing.positions.size(), 0);
    const double pressure = static_pressure(packing, network.contacts).trace() / 3.0;
    return enthalpy_hessian(packing, network, none_left_out, pressure, prestress);
}

/// All eigenvalues of the bordered matrix, in ascending order; translations moved far up.
Eigen::VectorXd eigenvalues_of(const EnthalpyHessian& hessian, const FreeStrains& free_strains) {
    Eigen::MatrixXd matrix = bordered_matrix(hessian, free_strains);
    matrix = Eigen::MatrixXd(matrix.selfadjointView<Eigen::Lower>());
    Eigen::MatrixXd translations = Eigen::MatrixXd::Zero(matrix.rows(), 3);
    for (Eigen::Index i = 0; i < hessian.displacement.rows(); ++i) translations(i, i % 3) = 1.0;
    matrix += translations * translations.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    return solver.eigenvalues();
}

double quotient(const EnthalpyHessian& hessian, const Stability& stability) {
    Eigen::VectorXd vector(hessian.displacement.rows() + strain_count);
    for (std::size_t i = 0; i < stability.mode.size(); ++i)
        vector.segment<3>(3 * static_cast<Eigen::Index>(i)) = stability.mode[i];
    vector.tail<strain_count>() = stability.mode_strain;
    EXPECT_NEAR(vector.norm(), 1.0, 1e-12);
    const auto matrix = bordered_matrix(hessian, all_strains());
    return vector.dot(matrix.selfadjointView<Eigen::Lower>() * vector);
}

/// A crystal with the crowd's freedom taken out: neighbors 12, every one a little shifted.
Packing shaken_crystal(double compression) {
    Packing packing = test::face_centered_cubic(3, std::sqrt(2.0) * (1.0 - compression), 1.0);
    const Packing shifts =
        test::random_spheres(Mat3::Identity() * 1e-3, static_cast<int>(packing.size()), 1.0, 4);
    for (Count i = 0; i < packing.size(); ++i) packing.positions[i] += shifts.positions[i];
    return packing;
}

TEST(Stability, SmallestEigenvalueIsThatOfTheWholeMatrix) {
    const Packing crowd = test::random_spheres(test::random_edges(7.0, 3), 100, 3.0, 21);
    for (const Packing& packing : {crowd, shaken_crystal(0.02)}) {
        const EnthalpyHessian hessian = hessian_of(packing);
        for (const FreeStrains& strains : {all_strains(), orthogonal_strains(), isotropic_strain(),
                                           FreeStrains(strain_count, 0)}) {
            const Eigen::VectorXd expected = eigenvalues_of(hessian, strains);
            const Stability found = find_stability(hessian, {.free_strains = strains});
            ASSERT_GT(std::abs(expected[0]), 1e-6);
            EXPECT_NEAR(found.smallest_eigenvalue, expected[0], 1e-7 * std::abs(expected[0]));
            EXPECT_EQ(found.stable, expected[0] > 0.0);
            EXPECT_NEAR(quotient(hessian, found), expected[0], 1e-7 * std::abs(expected[0]));
        }
    }
}

TEST(Stability, ACloseCrystalStandsAndASimpleCubicOneFalls) {
    EXPECT_TRUE(find_stability(hessian_of(shaken_crystal(0.02))).stable);
    EXPECT_FALSE(find_stability(hessian_of(test::simple_cubic(4, 0.98, 1.0))).stable);
}

TEST(Stability, ARattlerIsNoStableParticle) {
    Packing packing = shaken_crystal(0.02);
    EXPECT_TRUE(find_stability(hessian_of(packing)).stable);
    packing.positions.emplace_back(Vec3(0.5, 0.5, 0.5) * std::sqrt(2.0) * 0.98);
    packing.diameters.push_back(0.1);
    packing.ids.push_back(packing.size());
    const Stability found = find_stability(hessian_of(packing));
    EXPECT_FALSE(found.stable);
    EXPECT_NEAR(found.smallest_eigenvalue, 0.0, 1e-12);
}

TEST(Stability, OfNothingIsNotANumber) {
    const Stability found = find_stability(EnthalpyHessian{});
    EXPECT_FALSE(found.stable);
    EXPECT_TRUE(std::isnan(found.smallest_eigenvalue));
}

}  // namespace
}  // namespace jam
