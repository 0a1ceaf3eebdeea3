// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/hessian.h"

#include "contacts/elastic_laws.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

constexpr Index nowhere = -1;

/// Row of each particle among those taken, `nowhere` for the others.
std::vector<Index> rows_of(std::span<const std::uint8_t> left_out, std::vector<Index>& taken) {
    std::vector<Index> rows(left_out.size(), nowhere);
    for (std::size_t i = 0; i < left_out.size(); ++i) {
        if (left_out[i] != 0) continue;
        rows[i] = static_cast<Index>(taken.size());
        taken.push_back(static_cast<Index>(i));
    }
    return rows;
}

/// One contact as a spring: `arm` leads from the second center to the first.
struct Spring {
    Vec3 arm;
    Mat3 stiffness;
};

template <typename Law>
Spring spring_of(const Packing& packing, const Contact& contact, const Law& law, bool prestress) {
    const double diameter_1 = packing.diameters[contact.first];
    const double diameter_2 = packing.diameters[contact.second];
    const double distance = 0.5 * (diameter_1 + diameter_2) - contact.overlap;
    const double across = prestress ? contact.force / distance : 0.0;
    const double along = law.tangent(contact.overlap, diameter_1, diameter_2);
    const Mat3 projector = contact.normal * contact.normal.transpose();
    return {distance * contact.normal, along * projector - across * (Mat3::Identity() - projector)};
}

/// E_a r for the six unit strains, in columns.
Eigen::Matrix<double, 3, strain_count> strained(const Vec3& arm) {
    Eigen::Matrix<double, 3, strain_count> columns;
    for (int a = 0; a < strain_count; ++a) columns.col(a) = unit_strain(a) * arm;
    return columns;
}

/// Gathers the lower triangle, block by block.
class LowerTriangle {
  public:
    LowerTriangle(Index particle_count, std::size_t contact_count)
        : diagonal_(static_cast<std::size_t>(particle_count), Mat3::Zero()) {
        entries_.reserve(9 * contact_count + 6 * diagonal_.size());
    }

    void add_spring(Index row_1, Index row_2, const Mat3& stiffness) {
        diagonal_[row_1] += stiffness;
        diagonal_[row_2] += stiffness;
        const Index below = 3 * std::max(row_1, row_2);
        const Index left = 3 * std::min(row_1, row_2);
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                entries_.emplace_back(below + r, left + c, -stiffness(r, c));
    }

    Eigen::SparseMatrix<double> matrix() {
        const auto size = static_cast<Eigen::Index>(diagonal_.size());
        for (Eigen::Index i = 0; i < size; ++i)
            for (int c = 0; c < 3; ++c)
                for (int r = c; r < 3; ++r)
                    entries_.emplace_back(3 * i + r, 3 * i + c, diagonal_[i](r, c));
        Eigen::SparseMatrix<double> result(3 * size, 3 * size);
        result.setFromTriplets(entries_.begin(), entries_.end());
        return result;
    }

  private:
    std::vector<Mat3> diagonal_;
    std::vector<Eigen::Triplet<double>> entries_;
};

/// Second derivatives of det(1 + e).
Mat6 volume_curvature() {
    Mat6 curvature;
    for (int a = 0; a < strain_count; ++a)
        for (int b = 0; b < strain_count; ++b) {
            const Mat3 strain_a = unit_strain(a);
            const Mat3 strain_b = unit_strain(b);
            curvature(a, b) = strain_a.trace() * strain_b.trace() - (strain_a * strain_b).trace();
        }
    return curvature;
}

}  // namespace

Mat3 unit_strain(int a) {
    Mat3 strain = Mat3::Zero();
    if (a < 3) {
        strain(a, a) = 1.0;
    } else {
        const int row = a == 3 ? 1 : 0;
        const int column = a == 5 ? 1 : 2;
        strain(row, column) = strain(column, row) = 0.5;
    }
    return strain;
}

EnthalpyHessian enthalpy_hessian(const Packing& packing, const ForceNetwork& network,
                                 std::span<const std::uint8_t> left_out, double pressure,
                                 bool prestress) {
    EnthalpyHessian hessian;
    const std::vector<Index> rows = rows_of(left_out, hessian.particles);
    const Index count = hessian.particle_count();
    double squares = 0.0;
    for (const Index i : hessian.particles) squares += packing.diameters[i] * packing.diameters[i];
    hessian.strain_length = std::sqrt(squares);
    LowerTriangle displacement(count, network.contacts.size());
    hessian.mixed.setZero(Eigen::Index{3} * count, strain_count);
    hessian.volume = packing.cell.volume();
    hessian.strain = pressure * hessian.volume * volume_curvature();
    with_elastic_law(packing.material, [&](const auto& law) {
        for (const Contact& contact : network.contacts) {
            const Index row_1 = rows[contact.first];
            const Index row_2 = rows[contact.second];
            if (row_1 == nowhere || row_2 == nowhere) continue;
            const Spring spring = spring_of(packing, contact, law, prestress);
            const auto arms = strained(spring.arm);
            hessian.strain += arms.transpose() * spring.stiffness * arms;
            if (row_1 == row_2) continue;  // a particle and its own image move alike
            displacement.add_spring(row_1, row_2, spring.stiffness);
            hessian.mixed.middleRows<3>(Eigen::Index{3} * row_1) += spring.stiffness * arms;
            hessian.mixed.middleRows<3>(Eigen::Index{3} * row_2) -= spring.stiffness * arms;
        }
    });
    hessian.displacement = displacement.matrix();
    return hessian;
}

FreeStrains all_strains() {
    return Mat6::Identity();
}

FreeStrains orthogonal_strains() {
    return Mat6::Identity().leftCols<3>();
}

FreeStrains isotropic_strain() {
    return Mat6::Identity().leftCols<3>().rowwise().sum().normalized();
}

Eigen::SparseMatrix<double> bordered_matrix(const EnthalpyHessian& hessian,
                                            const FreeStrains& free_strains) {
    const Eigen::Index inner = hessian.displacement.rows();
    const Eigen::Index border = free_strains.cols();
    const double length = hessian.strain_length;
    const Eigen::MatrixXd mixed = hessian.mixed * free_strains / length;
    const Eigen::MatrixXd corner =
        free_strains.transpose() * hessian.strain * free_strains / (length * length);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(hessian.displacement.nonZeros() + mixed.size()) + 36);
    for (Eigen::Index column = 0; column < inner; ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(hessian.displacement, column); it; ++it)
            entries.emplace_back(it.row(), column, it.value());
        for (Eigen::Index a = 0; a < border; ++a)
            entries.emplace_back(inner + a, column, mixed(column, a));
    }
    for (Eigen::Index b = 0; b < border; ++b)
        for (Eigen::Index a = b; a < border; ++a)
            entries.emplace_back(inner + a, inner + b, corner(a, b));
    Eigen::SparseMatrix<double> matrix(inner + border, inner + border);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace jam
