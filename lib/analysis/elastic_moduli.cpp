// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/elastic_moduli.h"

#include "analysis/cholesky_factor.h"

#include <Eigen/LU>

#include <optional>

namespace jam {

namespace {

/// Of the mean diagonal: makes the matrix, which is blind to translations, one that can be
/// factored.
constexpr double shift_part = 1e-11;
constexpr int most_refinements = 100;
constexpr double wanted_residual = 1e-10;

/// What particles and cell do under unit forces on the six strains, in columns of the last rows.
/// The factor is that of matrix + shift; what the shift changes is made good step by step.
std::optional<Mat6> compliance_of(const Eigen::SparseMatrix<double>& matrix, double shift) {
    CholeskyFactor factor(matrix);
    if (!factor.factorize(shift)) return std::nullopt;
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(matrix.rows(), strain_count);
    forces.bottomRows<strain_count>().setIdentity();
    Eigen::MatrixXd answer = factor.solve(forces);
    for (int k = 0; k < most_refinements; ++k) {
        const Eigen::MatrixXd residual = forces - matrix.selfadjointView<Eigen::Lower>() * answer;
        if (residual.norm() < wanted_residual) return Mat6(answer.bottomRows<strain_count>());
        answer += factor.solve(residual);
    }
    return std::nullopt;
}

double bulk_of(const Mat6& stiffness) {
    return stiffness.topLeftCorner<3, 3>().sum() / 9.0;
}

double shear_of(const Mat6& stiffness) {
    const auto normal = stiffness.topLeftCorner<3, 3>();
    return (1.5 * normal.trace() - 0.5 * normal.sum()) / 15.0 +
           stiffness.bottomRightCorner<3, 3>().trace() / 5.0;
}

}  // namespace

ElasticModuli elastic_moduli(const EnthalpyHessian& hessian) {
    ElasticModuli moduli;
    if (hessian.particle_count() == 0) return moduli;
    const Eigen::SparseMatrix<double> matrix = bordered_matrix(hessian, all_strains());
    const double diagonal =
        hessian.displacement.diagonal().sum() / static_cast<double>(hessian.displacement.rows());
    if (!(diagonal > 0.0)) return moduli;
    const std::optional<Mat6> compliance = compliance_of(matrix, shift_part * diagonal);
    if (!compliance) return moduli;
    const double length = hessian.strain_length;
    moduli.stiffness = length * length / hessian.volume * compliance->inverse();
    moduli.affine = hessian.strain / hessian.volume;
    moduli.bulk = bulk_of(moduli.stiffness);
    moduli.shear = shear_of(moduli.stiffness);
    return moduli;
}

}  // namespace jam
