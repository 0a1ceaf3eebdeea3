// SPDX-License-Identifier: BSD-3-Clause
// The enthalpy around a state with its geometry made linear: contacts open and close in it, but no
// direction turns. What each step of Newton's method minimises.
#pragma once

#include "cell/periodic_cell.h"
#include "neighbors/neighbor_list.h"
#include "particles/material.h"
#include "particles/particles.h"

#include <Eigen/Core>

#include <vector>

namespace jam {

/// Components of a strain of the cell: xx, xy, xz, yy, yz, zz of an upper triangular matrix.
inline constexpr int cell_component_count = 6;
using CellComponents = Eigen::Matrix<double, cell_component_count, 1>;
using CellBlock = Eigen::Matrix<double, cell_component_count, cell_component_count>;
Mat3 upper_triangular(const CellComponents& components);

/// A pair that touches or may come to: `arm` leads from the second center to the first.
struct ModelPair {
    Index first, second;  ///< rows of the model
    double diameter_first, diameter_second;
    Vec3 arm;
    Vec3 normal;
    double overlap;         ///< below zero: a gap
    double force_over_arm;  ///< f / |r|, the prestress
    double reach() const { return 0.5 * (diameter_first + diameter_second); }
};

/// What is true at the present places.
struct EnthalpyState {
    double enthalpy = 0.0;  ///< U + p V
    double volume = 0.0;
    Eigen::VectorXd slope;  ///< derivatives by all unknowns
    double mean_force = 0.0;
    double cundall = 0.0;
    double pressure_error = 0.0;  ///< largest of six, over p
};

/// Second derivatives of the model, block by block.
struct ModelCurvature {
    std::vector<Mat3> of_pair;
    std::vector<Mat3> of_particle;
    Eigen::Matrix<double, Eigen::Dynamic, cell_component_count> border;
    CellBlock corner;
};

/// Unknowns: displacements of the n particles that are near another (3 n), then the strain (6).
class ContactModel {
  public:
    /// Takes pairs that are within `window` of touching. Centers of `particles` are fractional.
    ContactModel(const NeighborList& candidates, const PeriodicCell& cell,
                 const Particles& particles, const Material& material, double pressure,
                 double window);

    Eigen::Index unknown_count() const { return 3 * particle_count() + cell_component_count; }
    Eigen::Index particle_count() const { return static_cast<Eigen::Index>(particles_.size()); }
    const std::vector<Index>& particles() const { return particles_; }
    const std::vector<ModelPair>& pairs() const { return pairs_; }
    const EnthalpyState& now() const { return now_; }
    /// Sum of D^2 over the particles: what the strain weighs beside displacements.
    double strain_weight() const { return strain_weight_; }

    /// Enthalpy of the model at displacements and strain `x`, with damping |x|^2 mu / 2 added;
    /// fills `slope`, and `curvature` where it is not null.
    double evaluate(const Eigen::VectorXd& x, double mu, Eigen::VectorXd& slope,
                    ModelCurvature* curvature) const;

    /// Moves for real; now() follows.
    void move(const Eigen::VectorXd& x);

  private:
    Index row_of(Index particle, std::vector<Index>& rows, const Particles& particles);
    void evaluate_exactly();
    double add_volume(const CellComponents& strain, Eigen::VectorXd& slope,
                      ModelCurvature* curvature) const;

    Material material_;
    double pressure_;
    std::vector<Index> particles_;
    std::vector<ModelPair> pairs_;
    EnthalpyState now_;
    double strain_weight_ = 0.0;
};

}  // namespace jam
