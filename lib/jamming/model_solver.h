// SPDX-License-Identifier: BSD-3-Clause
// Linear systems of a contact model: a sparse Cholesky factor for the particles, a 6x6 complement
// for the cell (CHOLMOD, Chen et al., ACM Trans. Math. Softw. 35, 22, 2008).
#pragma once

#include "jamming/contact_model.h"

#include <memory>

namespace jam {

class ModelSolver {
  public:
    /// Finds the order of elimination for the model's pairs; it serves every curvature of theirs.
    explicit ModelSolver(const ContactModel& model);
    ~ModelSolver();
    ModelSolver(const ModelSolver&) = delete;
    ModelSolver& operator=(const ModelSolver&) = delete;

    /// Floating-point operations of one factorization.
    double operations() const;
    int factorizations() const { return factorizations_; }

    /// step = -(curvature + mu)^-1 slope; false unless the matrix is positive definite.
    bool solve(const ModelCurvature& curvature, double mu, const Eigen::VectorXd& slope,
               Eigen::VectorXd& step);

  private:
    struct Cholmod;
    void fill(const ModelCurvature& curvature, double mu);

    const ContactModel& model_;
    std::unique_ptr<Cholmod> cholmod_;
    int factorizations_ = 0;
};

}  // namespace jam
