// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/stability.h"

#include "analysis/cholesky_factor.h"
#include "core/random.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace jam {

namespace {

constexpr std::uint64_t start_seed = 1;
constexpr int most_steps = 120;
constexpr double wanted_residual = 1e-9;  // of the eigenvalue of the inverse

double mean_diagonal(const Eigen::SparseMatrix<double>& matrix) {
    return matrix.diagonal().cwiseAbs().sum() / static_cast<double>(matrix.rows());
}

/// Takes the mean displacement of the `count` particles away.
void remove_translation(Eigen::VectorXd& vector, Eigen::Index count) {
    Vec3 mean = Vec3::Zero();
    for (Eigen::Index i = 0; i < count; ++i) mean += vector.segment<3>(3 * i);
    mean /= static_cast<double>(count);
    for (Eigen::Index i = 0; i < count; ++i) vector.segment<3>(3 * i) -= mean;
}

Eigen::VectorXd random_start(Eigen::Index size, Eigen::Index count) {
    Eigen::VectorXd start(size);
    for (Eigen::Index i = 0; i < size; ++i)
        start[i] =
            uniform(start_seed, RandomStream::stability, static_cast<std::uint64_t>(i)) - 0.5;
    remove_translation(start, count);
    return start.normalized();
}

/// Factors matrix + shift with the smallest of `first` times a power of ten that makes it positive
/// definite.
void factorize_with_shift(CholeskyFactor& factor, double first) {
    for (double shift = first; !factor.factorize(shift);) shift *= 10.0;
}

/// Eigenvector of the largest eigenvalue of the inverse.
Eigen::VectorXd lowest_mode(const CholeskyFactor& factor, Eigen::Index size, Eigen::Index count) {
    const auto steps = static_cast<int>(std::min<Eigen::Index>(most_steps, size));
    Eigen::MatrixXd basis(size, steps);
    Eigen::VectorXd diagonal(steps);
    Eigen::VectorXd beside(steps);
    Eigen::VectorXd next = random_start(size, count);
    Eigen::VectorXd weights;
    for (int k = 0; k < steps; ++k) {
        basis.col(k) = next;
        next = factor.solve(next);
        remove_translation(next, count);
        diagonal[k] = next.dot(basis.col(k));
        // Twice, since once leaves what round-off brought in (Parlett, 1980).
        for (int pass = 0; pass < 2; ++pass)
            next -= basis.leftCols(k + 1) * (basis.leftCols(k + 1).transpose() * next);
        beside[k] = next.norm();
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
        small.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k));
        weights = small.eigenvectors().col(k);
        const double largest = small.eigenvalues()[k];
        if (beside[k] * std::abs(weights[k]) <= wanted_residual * largest) break;
        next /= beside[k];
    }
    return (basis.leftCols(weights.size()) * weights).normalized();
}

}  // namespace

Stability find_stability(const EnthalpyHessian& hessian, const StabilitySettings& settings) {
    const Eigen::Index count = hessian.particle_count();
    if (count == 0) return {};
    const Eigen::SparseMatrix<double> matrix = bordered_matrix(hessian, settings.free_strains);
    const double floor = settings.tolerance * mean_diagonal(hessian.displacement);
    if (!(floor > 0.0)) return {false, 0.0, {}, Vec6::Zero()};
    CholeskyFactor factor(matrix);
    factorize_with_shift(factor, floor);
    const Eigen::VectorXd mode = lowest_mode(factor, matrix.rows(), count);

    Stability result;
    result.smallest_eigenvalue = mode.dot(matrix.selfadjointView<Eigen::Lower>() * mode);
    result.stable = result.smallest_eigenvalue > floor;
    for (Eigen::Index i = 0; i < count; ++i) result.mode.emplace_back(mode.segment<3>(3 * i));
    result.mode_strain = settings.free_strains * mode.tail(settings.free_strains.cols());
    return result;
}

}  // namespace jam
