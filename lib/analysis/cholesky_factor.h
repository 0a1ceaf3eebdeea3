// SPDX-License-Identifier: BSD-3-Clause
// Sparse symmetric systems, and whether they are positive definite.
#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace jam {

/// Cholesky's factor of a sparse symmetric matrix plus a shift of its diagonal (CHOLMOD, Chen et
/// al., ACM Trans. Math. Softw. 35, 22, 2008). The order of elimination is found once; the shift
/// may change.
class CholeskyFactor {
  public:
    /// Of the symmetric matrix whose lower triangle is given; it must outlive the factor.
    explicit CholeskyFactor(const Eigen::SparseMatrix<double>& lower_triangle);
    ~CholeskyFactor();
    CholeskyFactor(const CholeskyFactor&) = delete;
    CholeskyFactor& operator=(const CholeskyFactor&) = delete;

    /// Factors matrix + shift 1; false if that is not positive definite. Throws InputError if
    /// memory does not suffice.
    bool factorize(double shift);

    /// (matrix + shift 1)^-1 times the columns, after a factorize that succeeded.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& columns) const;

  private:
    struct Cholmod;
    const Eigen::SparseMatrix<double>& matrix_;
    std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace jam
