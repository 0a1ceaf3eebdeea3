// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/cholesky_factor.h"

#include "core/check.h"
#include "core/without_openmp.h"

#include <Eigen/CholmodSupport>

namespace jam {

struct CholeskyFactor::Cholmod {
    Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
};

namespace {

void check_memory(int status, Eigen::Index rows) {
    require(status != CHOLMOD_OUT_OF_MEMORY && status != CHOLMOD_TOO_LARGE,
            "stiffness matrix: {} unknowns need more memory than there is to factor it; take a "
            "smaller packing",
            rows);
}

}  // namespace

CholeskyFactor::CholeskyFactor(const Eigen::SparseMatrix<double>& lower_triangle)
    : matrix_(lower_triangle), cholmod_(std::make_unique<Cholmod>()) {
    cholmod_->solver.cholmod().print = 0;
    cholmod_->solver.analyzePattern(matrix_);
    check_memory(cholmod_->solver.cholmod().status, matrix_.rows());
}

CholeskyFactor::~CholeskyFactor() = default;

bool CholeskyFactor::factorize(double shift) {
    const WithoutOpenMp one_thread;
    cholmod_->solver.setShift(shift);
    cholmod_->solver.factorize(matrix_);
    check_memory(cholmod_->solver.cholmod().status, matrix_.rows());
    return cholmod_->solver.info() == Eigen::Success;
}

Eigen::MatrixXd CholeskyFactor::solve(const Eigen::MatrixXd& columns) const {
    return cholmod_->solver.solve(columns);
}

}  // namespace jam
