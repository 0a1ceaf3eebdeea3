// SPDX-License-Identifier: BSD-3-Clause
#include "cell/periodic_cell.h"

#include "core/check.h"

#include <Eigen/Dense>

#include <cmath>

namespace jam {

namespace {

Mat3 inverse_of_upper(const Mat3& h) {
    Mat3 inverse = Mat3::Zero();
    for (int k = 0; k < 3; ++k) inverse(k, k) = 1.0 / h(k, k);
    inverse(0, 1) = -h(0, 1) * inverse(0, 0) * inverse(1, 1);
    inverse(1, 2) = -h(1, 2) * inverse(1, 1) * inverse(2, 2);
    inverse(0, 2) =
        (h(0, 1) * h(1, 2) - h(0, 2) * h(1, 1)) * inverse(0, 0) * inverse(1, 1) * inverse(2, 2);
    return inverse;
}

}  // namespace

PeriodicCell::PeriodicCell(const Mat3& h) : h_(h) {
    require(h.allFinite(), "cell: an edge is not a finite number; give finite edges");
    require(h(1, 0) == 0.0 && h(2, 0) == 0.0 && h(2, 1) == 0.0,
            "cell: edges must have the form a = (lx,0,0), b = (xy,ly,0), c = (xz,yz,lz); rotate "
            "the cell and its particles into it");
    require(h(0, 0) > 0.0 && h(1, 1) > 0.0 && h(2, 2) > 0.0,
            "cell: lx = {}, ly = {}, lz = {}; all three must be above zero", h(0, 0), h(1, 1),
            h(2, 2));
    inverse_ = inverse_of_upper(h_);
    for (int k = 0; k < 3; ++k) widths_[k] = 1.0 / inverse_.row(k).norm();
}

PeriodicCell PeriodicCell::cubic(double side) {
    return PeriodicCell(Mat3::Identity() * side);
}

bool PeriodicCell::is_reduced() const {
    return std::abs(h_(0, 1)) <= 0.5 * h_(0, 0) && std::abs(h_(0, 2)) <= 0.5 * h_(0, 0) &&
           std::abs(h_(1, 2)) <= 0.5 * h_(1, 1);
}

PeriodicCell::Reduction PeriodicCell::reduced() const {
    // Edges change as h' = h M with M unimodular, so s' = M^-1 s; the entries of M^-1 are collected
    // as each edge has whole multiples of the earlier ones taken off.
    Mat3 h = h_;
    Mat3 change = Mat3::Identity();
    const auto take_off = [&](int edge, int earlier) {
        const double times = std::round(h(earlier, edge) / h(earlier, earlier));
        h.col(edge) -= times * h.col(earlier);
        change.row(earlier) += times * change.row(edge);
    };
    take_off(2, 1);
    take_off(2, 0);
    take_off(1, 0);
    return {PeriodicCell(h), change};
}

Vec3 wrapped(const Vec3& fractional) {
    Vec3 s = fractional - fractional.array().floor().matrix();
    for (int k = 0; k < 3; ++k)
        if (s[k] >= 1.0) s[k] = 0.0;
    return s;
}

double worst_shortening(const PeriodicCell& before, const PeriodicCell& after) {
    const Mat3 deformation = after.matrix() * before.inverse();
    const Mat3 stretch_squared = deformation.transpose() * deformation;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(stretch_squared, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
}

}  // namespace jam
