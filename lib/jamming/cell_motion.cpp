// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/cell_motion.h"

namespace jam {

Mat3 allowed_strain(const Mat3& strain, FreeCell free_cell) {
    if (free_cell == FreeCell::isotropic) return Mat3::Identity() * (strain.trace() / 3.0);
    if (free_cell == FreeCell::orthogonal) return Mat3(strain.diagonal().asDiagonal());
    return strain.triangularView<Eigen::Upper>();
}

PeriodicCell strained_cell(const PeriodicCell& cell, const Mat3& strain) {
    return PeriodicCell(Mat3((Mat3::Identity() + strain + 0.5 * strain * strain) * cell.matrix())
                            .triangularView<Eigen::Upper>()
                            .toDenseMatrix());
}

void reduce_tilt(JamState& state) {
    if (state.cell.is_reduced()) return;
    const PeriodicCell::Reduction reduction = state.cell.reduced();
    state.cell = reduction.cell;
    for (Sphere& sphere : state.particles.spheres) sphere.center = reduction.change * sphere.center;
    state.quasistatic.leap = {};
}

}  // namespace jam
