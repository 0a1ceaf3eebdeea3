// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/model_solver.h"

#include "core/without_openmp.h"

#include <Eigen/Cholesky>
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>

namespace jam {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Lower triangle with an entry wherever a pair or a particle may put one.
Sparse pattern_of(const ContactModel& model) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * model.pairs().size() + 6 * model.particles().size());
    for (Eigen::Index i = 0; i < model.particle_count(); ++i)
        for (int column = 0; column < 3; ++column)
            for (int row = column; row < 3; ++row)
                entries.emplace_back(3 * i + row, 3 * i + column, 1.0);
    for (const ModelPair& pair : model.pairs()) {
        if (pair.first == pair.second) continue;
        const Eigen::Index below = std::max(pair.first, pair.second);
        const Eigen::Index left = std::min(pair.first, pair.second);
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                entries.emplace_back(3 * below + row, 3 * left + column, 1.0);
    }
    Sparse matrix(3 * model.particle_count(), 3 * model.particle_count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Where in the values the three columns of a block begin.
using BlockPlace = std::array<Eigen::Index, 3>;

BlockPlace block_place(const Sparse& matrix, Index below, Index left) {
    BlockPlace place{};
    for (int column = 0; column < 3; ++column) {
        const auto* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[3 * left + column];
        const auto* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[3 * left + column + 1];
        place[static_cast<std::size_t>(column)] =
            std::lower_bound(begin, end, 3 * below) - matrix.innerIndexPtr();
    }
    return place;
}

}  // namespace

struct ModelSolver::Cholmod {
    Sparse matrix;
    std::vector<BlockPlace> of_pair;
    Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> solver;
};

ModelSolver::ModelSolver(const ContactModel& model)
    : model_(model), cholmod_(std::make_unique<Cholmod>()) {
    cholmod_->matrix = pattern_of(model);
    cholmod_->solver.cholmod().print = 0;
    cholmod_->solver.analyzePattern(cholmod_->matrix);
    for (const ModelPair& pair : model.pairs())
        cholmod_->of_pair.push_back(block_place(cholmod_->matrix, std::max(pair.first, pair.second),
                                                std::min(pair.first, pair.second)));
}

ModelSolver::~ModelSolver() = default;

double ModelSolver::operations() const {
    return cholmod_->solver.cholmod().fl;
}

void ModelSolver::fill(const ModelCurvature& curvature, double mu) {
    Sparse& matrix = cholmod_->matrix;
    double* values = matrix.valuePtr();
    std::fill(values, values + matrix.nonZeros(), 0.0);
    for (std::size_t i = 0; i < curvature.of_particle.size(); ++i)
        for (int column = 0; column < 3; ++column) {
            const Eigen::Index begin =
                matrix.outerIndexPtr()[3 * i + static_cast<std::size_t>(column)];
            for (int row = column; row < 3; ++row)
                values[begin + row - column] =
                    curvature.of_particle[i](row, column) + (row == column ? mu : 0.0);
        }
    const std::vector<ModelPair>& pairs = model_.pairs();
    for (std::size_t at = 0; at < pairs.size(); ++at) {
        if (pairs[at].first == pairs[at].second) continue;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                values[cholmod_->of_pair[at][static_cast<std::size_t>(column)] + row] -=
                    curvature.of_pair[at](row, column);
    }
}

bool ModelSolver::solve(const ModelCurvature& curvature, double mu, const Eigen::VectorXd& slope,
                        Eigen::VectorXd& step) {
    const WithoutOpenMp one_thread;
    ++factorizations_;
    fill(curvature, mu);
    cholmod_->solver.factorize(cholmod_->matrix);
    if (cholmod_->solver.info() != Eigen::Success) return false;
    const Eigen::Index inner = 3 * model_.particle_count();
    Eigen::MatrixXd right(inner, cell_component_count + 1);
    right << curvature.border, -slope.head(inner);
    const Eigen::MatrixXd solved = cholmod_->solver.solve(right);
    const auto by_strain = solved.leftCols<cell_component_count>();
    CellBlock complement = curvature.corner - curvature.border.transpose() * by_strain;
    complement.diagonal().array() += mu * model_.strain_weight();
    const Eigen::LDLT<CellBlock> factor(complement);
    if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0)) return false;
    const CellComponents strain = factor.solve(
        CellComponents(-slope.tail<cell_component_count>() -
                       curvature.border.transpose() * solved.col(cell_component_count)));
    step.resize(inner + cell_component_count);
    step.head(inner) = solved.col(cell_component_count) - by_strain * strain;
    step.tail<cell_component_count>() = strain;
    return true;
}

}  // namespace jam
