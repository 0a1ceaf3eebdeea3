// SPDX-License-Identifier: BSD-3-Clause
// How the enthalpy of a packing curves: the stiffness of its contacts, the prestress in them, and
// the cell.
#pragma once

#include "analysis/force_network.h"

#include <Eigen/SparseCore>

#include <cstdint>
#include <span>
#include <vector>

namespace jam {

/// Components of a symmetric strain, in Voigt's order and with engineering shears: e_xx, e_yy,
/// e_zz, 2 e_yz, 2 e_xz, 2 e_xy.
inline constexpr int strain_count = 6;
using Vec6 = Eigen::Matrix<double, strain_count, 1>;
using Mat6 = Eigen::Matrix<double, strain_count, strain_count>;

/// The strain of which component `a` is 1 and all others are 0.
Mat3 unit_strain(int a);

/// Second derivatives of H(u, e) = sum over contacts of U(|r_c|) + p V, with
/// r_c = (1 + e) r_c0 + u_first - u_second and V = det(1 + e) V_0, at u = 0, e = 0: what a packing
/// answers to displacements u of its particles (Cartesian, beyond the strain) and a strain e of its
/// cell. A contact with unit normal n, distance r, force f and tangent stiffness k has
/// B = k n n^T - (f / r) (1 - n n^T), the last part being the prestress.
struct EnthalpyHessian {
    std::vector<Index> particles;  ///< place in the packing of each of the n particles
    /// 3n x 3n, symmetric, of which the lower triangle is held: sum over contacts of +B on the
    /// diagonal blocks and -B off it.
    Eigen::SparseMatrix<double> displacement;
    /// 3n x 6: d2H / du de = sum over contacts of +-B E_a r, E_a the unit strain.
    Eigen::Matrix<double, Eigen::Dynamic, strain_count> mixed;
    /// 6 x 6: sum over contacts of (E_a r)^T B (E_b r), and p V (tr E_a tr E_b - tr E_a E_b).
    Mat6 strain;
    double volume = 0.0;  ///< of the cell
    /// l = sqrt(sum of D^2): l e is a length as u is, and weighs in the cell as the cell's inertia
    /// does in the equations of motion.
    double strain_length = 0.0;

    Index particle_count() const { return static_cast<Index>(particles.size()); }
};

/// Of the particles that `left_out` (length N; 1: left out, 0: taken) leaves, and the contacts
/// among them: network.rattlers.is_rattler leaves the backbone. `pressure` is the applied p; it is
/// isotropic, as a pressure that is not has no potential. With `prestress` false the contacts are
/// springs at rest.
EnthalpyHessian enthalpy_hessian(const Packing& packing, const ForceNetwork& network,
                                 std::span<const std::uint8_t> left_out, double pressure,
                                 bool prestress = true);

/// Ways in which the cell may follow, one a column, in the components of a strain.
using FreeStrains = Eigen::Matrix<double, strain_count, Eigen::Dynamic>;
FreeStrains all_strains();         ///< three edges, three tilts
FreeStrains orthogonal_strains();  ///< three edges
FreeStrains isotropic_strain();    ///< the volume alone

/// One matrix of it all, its lower triangle held: rows of the particles, then one row for the
/// amplitude, times strain_length, of each of `free_strains` (none: a cell that does not give).
Eigen::SparseMatrix<double> bordered_matrix(const EnthalpyHessian& hessian,
                                            const FreeStrains& free_strains);

}  // namespace jam
