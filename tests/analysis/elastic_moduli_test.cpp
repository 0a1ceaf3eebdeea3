// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/elastic_moduli.h"

#include "analysis/static_stress.h"
#include "support/packings.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

const std::vector<std::uint8_t> all_taken(108, 0);

double mean_pressure(const Packing& packing) {
    return static_pressure(packing, find_contacts(packing)).trace() / 3.0;
}

/// Face-centered cubic, with diameters that differ a little, so that particles move unlike the
/// cell.
Packing uneven_crystal(double lattice_constant) {
    Packing packing = test::face_centered_cubic(3, lattice_constant, 1.0);
    for (std::size_t i = 0; i < packing.diameters.size(); ++i)
        packing.diameters[i] += 0.01 * static_cast<double>(i * 37 % 11) / 11.0;
    return packing;
}

EnthalpyHessian hessian_at(const Packing& packing, double pressure) {
    return enthalpy_hessian(packing, find_force_network(packing), all_taken, pressure);
}

/// Newton's steps to where all forces balance in the given cell.
void balance(Packing& packing) {
    for (int step = 0; step < 12; ++step) {
        const ForceNetwork network = find_force_network(packing);
        Eigen::MatrixXd matrix = enthalpy_hessian(packing, network, all_taken, 0.0).displacement;
        matrix = Eigen::MatrixXd(matrix.selfadjointView<Eigen::Lower>());
        Eigen::VectorXd forces(matrix.rows());
        for (Index i = 0; i < 108; ++i)
            forces.segment<3>(3 * Eigen::Index{i}) = net_force(network, i);
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
            for (Eigen::Index j = i % 3; j < matrix.cols(); j += 3) matrix(i, j) += 0.01;
        const Eigen::VectorXd moves = matrix.ldlt().solve(forces);
        for (Index i = 0; i < 108; ++i)
            packing.positions[i] += moves.segment<3>(3 * Eigen::Index{i});
    }
}

Packing strained(const Packing& packing, const Mat3& upper_strain) {
    const Mat3 deformation = Mat3::Identity() + upper_strain;
    Packing result = packing;
    result.cell = PeriodicCell(Mat3(deformation * packing.cell.matrix()));
    for (Vec3& position : result.positions) position = deformation * position;
    balance(result);
    return result;
}

TEST(ElasticModuli, OfSpringsOnACubicLattice) {
    // Springs k between the 12 nearest neighbors: C_11 = 2 k / a, C_12 = C_44 = k / a.
    const double a = std::sqrt(2.0) * 0.98;
    const Packing packing = test::face_centered_cubic(3, a, 1.0);
    const ForceNetwork network = find_force_network(packing);
    const ElasticModuli moduli =
        elastic_moduli(enthalpy_hessian(packing, network, all_taken, 0.0, false));
    EXPECT_NEAR(moduli.stiffness(0, 0), 2.0 / a, 1e-9);
    EXPECT_NEAR(moduli.stiffness(0, 1), 1.0 / a, 1e-9);
    EXPECT_NEAR(moduli.stiffness(3, 3), 1.0 / a, 1e-9);
    EXPECT_NEAR(moduli.stiffness(3, 4), 0.0, 1e-9);
    EXPECT_NEAR(moduli.bulk, 4.0 / 3.0 / a, 1e-9);
    EXPECT_NEAR(moduli.shear, 0.8 / a, 1e-9);
}

TEST(ElasticModuli, AreTheDifferencesOfPressures) {
    for (const ContactLaw law : {ContactLaw::hooke, ContactLaw::hertz}) {
        Packing packing = uneven_crystal(std::sqrt(2.0) * 0.96);
        packing.material.law = law;
        balance(packing);
        const double pressure = mean_pressure(packing);
        const ElasticModuli moduli = elastic_moduli(hessian_at(packing, pressure));

        constexpr double step = 1e-5;
        const Mat3 wider = Mat3::Identity() * step;
        const double change =
            mean_pressure(strained(packing, wider)) - mean_pressure(strained(packing, -wider));
        const double expected_bulk = -change / (6.0 * step);
        EXPECT_GT(expected_bulk, 0.1);
        EXPECT_NEAR(moduli.bulk, expected_bulk, 2e-3 * expected_bulk);

        Mat3 sheared = Mat3::Zero();
        sheared(0, 1) = step;
        const auto shear_pressure = [&](const Mat3& strain) {
            const Packing after = strained(packing, strain);
            return static_pressure(after, find_contacts(after))(0, 1);
        };
        const double expected_shear =
            -(shear_pressure(sheared) - shear_pressure(-sheared)) / (2.0 * step);
        EXPECT_GT(expected_shear, 0.1);
        EXPECT_NEAR(moduli.stiffness(5, 5), expected_shear, 2e-3 * expected_shear);

        EXPECT_GT(moduli.affine(0, 0), moduli.stiffness(0, 0));
    }
}

TEST(ElasticModuli, OfWhatFallsAreNotNumbers) {
    const Packing packing = test::simple_cubic(4, 0.98, 1.0);
    const ForceNetwork network = find_force_network(packing);
    const std::vector<std::uint8_t> none(packing.positions.size(), 0);
    EXPECT_TRUE(std::isnan(
        elastic_moduli(enthalpy_hessian(packing, network, none, mean_pressure(packing))).bulk));
    EXPECT_TRUE(std::isnan(elastic_moduli(EnthalpyHessian{}).shear));
}

}  // namespace
}  // namespace jam
