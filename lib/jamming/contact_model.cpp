// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/contact_model.h"

#include "contacts/elastic_laws.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

using ArmMap = Eigen::Matrix<double, 3, cell_component_count>;

/// Change of `arm` with each component of the strain, in columns.
ArmMap arm_map(const Vec3& arm) {
    ArmMap map = ArmMap::Zero();
    map.row(0).segment<3>(0) = arm.transpose();
    map.row(1).segment<2>(3) = arm.tail<2>().transpose();
    map(2, 5) = arm[2];
    return map;
}

Vec3 relative_motion(const Eigen::VectorXd& x, const ModelPair& pair) {
    return x.segment<3>(3 * Eigen::Index{pair.first}) -
           x.segment<3>(3 * Eigen::Index{pair.second}) +
           arm_map(pair.arm) * x.tail<cell_component_count>();
}

void add_to_ends(const ModelPair& pair, const Vec3& slope_by_arm, Eigen::VectorXd& slope) {
    slope.segment<3>(3 * Eigen::Index{pair.first}) += slope_by_arm;
    slope.segment<3>(3 * Eigen::Index{pair.second}) -= slope_by_arm;
    slope.tail<cell_component_count>() += arm_map(pair.arm).transpose() * slope_by_arm;
}

void add_curvature(const ModelPair& pair, std::size_t at, const Mat3& block,
                   ModelCurvature& curvature) {
    curvature.of_pair[at] = block;
    const ArmMap map = arm_map(pair.arm);
    curvature.corner += map.transpose() * block * map;
    if (pair.first == pair.second) return;  // a particle and its own image move alike
    curvature.of_particle[static_cast<std::size_t>(pair.first)] += block;
    curvature.of_particle[static_cast<std::size_t>(pair.second)] += block;
    curvature.border.middleRows<3>(3 * Eigen::Index{pair.first}) += block * map;
    curvature.border.middleRows<3>(3 * Eigen::Index{pair.second}) -= block * map;
}

/// One pair at the relative motion `apart`: energy, and its derivatives by the arm.
struct PairModel {
    double energy;
    Vec3 slope;
    Mat3 block;
};

template <typename Law>
PairModel pair_model(const ModelPair& pair, const Vec3& apart, const Law& law) {
    const double along = pair.normal.dot(apart);
    const Vec3 across = apart - along * pair.normal;
    const double overlap = std::max(0.0, pair.overlap - along);
    const double force = law.force(overlap, pair.diameter_first, pair.diameter_second);
    const double tangent =
        overlap > 0.0 ? law.tangent(overlap, pair.diameter_first, pair.diameter_second) : 0.0;
    const double prestress = pair.force_over_arm;
    const Mat3 projector = pair.normal * pair.normal.transpose();
    return {law.energy(overlap, pair.diameter_first, pair.diameter_second) -
                0.5 * prestress * across.squaredNorm(),
            -force * pair.normal - prestress * across,
            tangent * projector - prestress * (Mat3::Identity() - projector)};
}

}  // namespace

Mat3 upper_triangular(const CellComponents& e) {
    Mat3 matrix;
    matrix << e[0], e[1], e[2], 0.0, e[3], e[4], 0.0, 0.0, e[5];
    return matrix;
}

ContactModel::ContactModel(const NeighborList& candidates, const PeriodicCell& cell,
                           const Particles& particles, const Material& material, double pressure,
                           double window)
    : material_(material), pressure_(pressure) {
    std::vector<Index> rows(particles.spheres.size(), -1);
    for (Index i = 0; i < particles.size(); ++i) {
        const Sphere& sphere = particles.spheres[static_cast<std::size_t>(i)];
        for (const Neighbor neighbor : candidates.row(i)) {
            const Sphere& other = particles.spheres[static_cast<std::size_t>(neighbor.particle())];
            const ImageShift& shift = image_shifts[neighbor.image()];
            const Vec3 arm =
                cell.cartesian(sphere.center - other.center - Vec3(shift.x, shift.y, shift.z));
            if (arm.norm() > 0.5 * (sphere.diameter + other.diameter) + window) continue;
            const Index first = row_of(i, rows, particles);
            const Index second = row_of(neighbor.particle(), rows, particles);
            pairs_.push_back(
                {first, second, sphere.diameter, other.diameter, arm, Vec3::Zero(), 0.0, 0.0});
        }
    }
    now_.volume = cell.volume();
    evaluate_exactly();
}

Index ContactModel::row_of(Index particle, std::vector<Index>& rows, const Particles& particles) {
    Index& row = rows[static_cast<std::size_t>(particle)];
    if (row < 0) {
        row = static_cast<Index>(particles_.size());
        particles_.push_back(particle);
        const double diameter = particles.spheres[static_cast<std::size_t>(particle)].diameter;
        strain_weight_ += diameter * diameter;
    }
    return row;
}

void ContactModel::evaluate_exactly() {
    now_.slope.setZero(unknown_count());
    const double work = pressure_ * now_.volume;
    now_.enthalpy = work;
    double magnitudes = 0.0;
    double contacts = 0.0;
    with_elastic_law(material_, [&](const auto& law) {
        for (ModelPair& pair : pairs_) {
            const double distance = pair.arm.norm();
            pair.normal = pair.arm / distance;
            pair.overlap = pair.reach() - distance;
            pair.force_over_arm = 0.0;
            if (pair.overlap <= 0.0) continue;
            const double force = law.force(pair.overlap, pair.diameter_first, pair.diameter_second);
            pair.force_over_arm = force / distance;
            now_.enthalpy += law.energy(pair.overlap, pair.diameter_first, pair.diameter_second);
            magnitudes += force;
            contacts += 1.0;
            add_to_ends(pair, -force * pair.normal, now_.slope);
        }
    });
    auto strain_slope = now_.slope.tail<cell_component_count>();
    for (const int diagonal : {0, 3, 5}) strain_slope[diagonal] += work;
    double net = 0.0;
    for (Eigen::Index i = 0; i < particle_count(); ++i) net += now_.slope.segment<3>(3 * i).norm();
    now_.mean_force = contacts > 0.0 ? magnitudes / contacts : 0.0;
    now_.cundall = net / magnitudes;
    now_.pressure_error = strain_slope.cwiseAbs().maxCoeff() / work;
}

double ContactModel::add_volume(const CellComponents& strain, Eigen::VectorXd& slope,
                                ModelCurvature* curvature) const {
    const double work = pressure_ * now_.volume;
    const double x = 1.0 + strain[0];
    const double y = 1.0 + strain[3];
    const double z = 1.0 + strain[5];
    auto strain_slope = slope.tail<cell_component_count>();
    strain_slope[0] += work * y * z;
    strain_slope[3] += work * x * z;
    strain_slope[5] += work * x * y;
    if (curvature != nullptr) {
        CellBlock& corner = curvature->corner;
        corner(0, 3) = corner(3, 0) = work * z;
        corner(0, 5) = corner(5, 0) = work * y;
        corner(3, 5) = corner(5, 3) = work * x;
    }
    return work * x * y * z;
}

double ContactModel::evaluate(const Eigen::VectorXd& x, double mu, Eigen::VectorXd& slope,
                              ModelCurvature* curvature) const {
    const CellComponents strain = x.tail<cell_component_count>();
    slope = mu * x;
    slope.tail<cell_component_count>() *= strain_weight_;
    double value = 0.5 * x.dot(slope);
    if (curvature != nullptr) {
        curvature->of_pair.resize(pairs_.size());
        curvature->of_particle.assign(particles_.size(), Mat3::Zero());
        curvature->border.setZero(3 * particle_count(), cell_component_count);
        curvature->corner.setZero();
    }
    value += add_volume(strain, slope, curvature);
    with_elastic_law(material_, [&](const auto& law) {
        for (std::size_t at = 0; at < pairs_.size(); ++at) {
            const ModelPair& pair = pairs_[at];
            const PairModel model = pair_model(pair, relative_motion(x, pair), law);
            value += model.energy;
            add_to_ends(pair, model.slope, slope);
            if (curvature != nullptr) add_curvature(pair, at, model.block, *curvature);
        }
    });
    return value;
}

void ContactModel::move(const Eigen::VectorXd& x) {
    for (ModelPair& pair : pairs_) pair.arm += relative_motion(x, pair);
    const CellComponents strain = x.tail<cell_component_count>();
    now_.volume *= (1.0 + strain[0]) * (1.0 + strain[3]) * (1.0 + strain[5]);
    evaluate_exactly();
}

}  // namespace jam
