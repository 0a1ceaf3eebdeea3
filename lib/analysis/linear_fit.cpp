// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/linear_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

LinearFit fit_line(std::span<const double> x, std::span<const double> y,
                   std::span<const double> errors) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto count = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixX2d design(count, 2);
    Eigen::VectorXd target(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        design.row(i) << 1.0 / errors[i], x[i] / errors[i];
        target[i] = y[i] / errors[i];
    }
    const auto decomposition = design.colPivHouseholderQr();
    if (count < 2 || decomposition.rank() < 2)
        return {nan, nan, nan, nan, nan, static_cast<int>(count)};
    const Eigen::Vector2d line = decomposition.solve(target);
    const Eigen::Matrix2d covariance = (design.transpose() * design).inverse();
    const double chi_squared = (target - design * line).squaredNorm();
    const double reduced = count > 2 ? chi_squared / static_cast<double>(count - 2) : nan;
    const double enlarged = count > 2 ? std::max(1.0, std::sqrt(reduced)) : 1.0;
    return {line[0], enlarged * std::sqrt(covariance(0, 0)),
            line[1], enlarged * std::sqrt(covariance(1, 1)),
            reduced, static_cast<int>(count)};
}

}  // namespace jam
