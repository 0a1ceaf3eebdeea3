// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/newton_relaxation.h"

#include "contacts/elastic_laws.h"
#include "jamming/contact_model.h"
#include "jamming/model_solver.h"

#include <algorithm>
#include <cmath>

namespace jam {

namespace {

using Eigen::VectorXd;

constexpr double window_in_mean_overlaps = 1000.0;
constexpr double largest_move_in_windows = 0.2;
constexpr int most_inner_steps = 12;
constexpr double inner_accuracy = 1e-2;  // of the model's slope at the start
constexpr double least_damping = 1e-8;   // times the mean force
constexpr double first_damping = 1.0;
constexpr double most_damping = 1e6;
constexpr int steps_to_bring_damping_down = 2;

double mean_overlap_of(const NeighborList& candidates, const PeriodicCell& cell,
                       const Particles& particles) {
    double sum = 0.0;
    double contacts = 0.0;
    for (Index i = 0; i < particles.size(); ++i) {
        const Sphere& sphere = particles.spheres[static_cast<std::size_t>(i)];
        for (const Neighbor neighbor : candidates.row(i)) {
            const Sphere& other = particles.spheres[static_cast<std::size_t>(neighbor.particle())];
            const ImageShift& shift = image_shifts[neighbor.image()];
            const double distance =
                cell.cartesian(sphere.center - other.center - Vec3(shift.x, shift.y, shift.z))
                    .norm();
            const double overlap = 0.5 * (sphere.diameter + other.diameter) - distance;
            if (overlap <= 0.0) continue;
            sum += overlap;
            contacts += 1.0;
        }
    }
    return contacts > 0.0 ? sum / contacts : 0.0;
}

double largest_displacement(const VectorXd& x) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i + cell_component_count < x.size(); i += 3)
        largest = std::max(largest, x.segment<3>(i).norm());
    return largest;
}

/// Where along `step` from `x` the model's slope vanishes, to a tenth: regula falsi, kept off the
/// ends.
double line_search(const ContactModel& model, double mu, const VectorXd& x, const VectorXd& step,
                   double slope_before) {
    VectorXd slope;
    const auto slope_at = [&](double t) {
        model.evaluate(x + t * step, mu, slope, nullptr);
        return slope.dot(step);
    };
    const double accepted = 0.1 * std::abs(slope_before);
    double low = 0.0;
    double high = 1.0;
    double slope_low = slope_before;
    double slope_high = slope_at(1.0);
    double t = 1.0;
    for (int k = 0; k < 20 && std::max(slope_high, 0.0) > accepted; ++k) {
        const double share = slope_low / (slope_low - slope_high);
        t = low + std::clamp(share, 0.1, 0.9) * (high - low);
        const double here = slope_at(t);
        if (std::abs(here) <= accepted) return t;
        (here > 0.0 ? high : low) = t;
        (here > 0.0 ? slope_high : slope_low) = here;
    }
    return t;
}

/// The descent: damping is carried from step to step.
class Descent {
  public:
    Descent(const NewtonSettings& settings, ContactModel& model, ModelSolver& solver,
            double largest_move)
        : settings_(settings), model_(model), solver_(solver), largest_move_(largest_move) {}

    NewtonResult run(Mat3& deformation, VectorXd& displacement) {
        NewtonResult result{.tried = true};
        while (!reached() && solver_.factorizations() < settings_.most_factorizations &&
               damping_ < most_damping && displacement_left_ > 0.0 && !stays_damped(result)) {
            VectorXd step;
            const double predicted = minimise_model(step);
            if (!(predicted > 0.0)) break;
            if (!take(step, predicted)) continue;
            ++result.steps;
            follow(step, deformation, displacement);
        }
        result.converged = reached();
        result.factorizations = solver_.factorizations();
        result.operations = solver_.operations();
        result.cundall = model_.now().cundall;
        result.pressure_error = model_.now().pressure_error;
        return result;
    }

  private:
    bool stays_damped(const NewtonResult& so_far) const {
        return so_far.steps >= steps_to_bring_damping_down && damping_ >= first_damping;
    }

    bool reached() const {
        return model_.now().cundall <= settings_.cundall &&
               model_.now().pressure_error <= settings_.cundall;
    }

    /// Solves for a direction at the curvature given, with more damping if it takes that.
    bool find_direction(const ModelCurvature& curvature, const VectorXd& x, double& mu,
                        VectorXd& slope, VectorXd& step) {
        while (!solver_.solve(curvature, mu, slope, step)) {
            if (damping_ > most_damping || solver_.factorizations() >= factorization_limit())
                return false;
            mu *= 4.0;
            damping_ *= 4.0;
            model_.evaluate(x, mu, slope, nullptr);
        }
        return true;
    }

    /// Minimum of the model, contacts opening and closing; returns by how much it lies lower.
    double minimise_model(VectorXd& x) {
        double mu = damping_ * model_.now().mean_force;
        x.setZero(model_.unknown_count());
        VectorXd slope;
        VectorXd step;
        const double before = model_.evaluate(x, mu, slope, &curvature_);
        const double enough = inner_accuracy * slope.norm();
        double value = before;
        for (int inner = 0; inner < most_inner_steps && slope.norm() > enough; ++inner) {
            if (!find_direction(curvature_, x, mu, slope, step)) return 0.0;
            x += line_search(model_, mu, x, step, slope.dot(step)) * step;
            value = model_.evaluate(x, mu, slope, &curvature_);
        }
        // Rounding hides what is gained close to the minimum.
        return std::max(before - value, 1e-16 * std::abs(before));
    }

    /// Moves, unless the true enthalpy grows; near the minimum, where rounding hides its change,
    /// unless the forces do.
    bool take(VectorXd& step, double predicted) {
        const double largest = largest_displacement(step);
        const double scale = std::min(1.0, largest_move_ / largest);
        step *= scale;
        const ContactModel before = model_;
        model_.move(step);
        const double enthalpy = before.now().enthalpy;
        const bool hidden = predicted < 1e-12 * std::abs(enthalpy);
        const double gained = enthalpy - model_.now().enthalpy;
        const bool better =
            hidden ? force_norm(model_) < force_norm(before) : gained > 1e-3 * predicted * scale;
        if (!better) {
            model_ = before;
            damping_ *= 4.0;
            return false;
        }
        const bool as_predicted = hidden || gained > 0.75 * predicted;
        if (scale == 1.0 && as_predicted)
            damping_ = std::max(least_damping, damping_ / 4.0);
        else if (scale < 0.3 || gained < 0.4 * predicted * scale)
            damping_ *= 4.0;
        return true;
    }

    double force_norm(const ContactModel& model) const {
        const VectorXd& slope = model.now().slope;
        const Eigen::Index inner = slope.size() - cell_component_count;
        return slope.head(inner).squaredNorm() +
               slope.tail(cell_component_count).squaredNorm() / model.strain_weight();
    }

    void follow(const VectorXd& step, Mat3& deformation, VectorXd& displacement) {
        const Mat3 strain =
            Mat3::Identity() + upper_triangular(CellComponents(step.tail<cell_component_count>()));
        for (Eigen::Index i = 0; i < displacement.size(); i += 3)
            displacement.segment<3>(i) = strain * displacement.segment<3>(i) + step.segment<3>(i);
        deformation = strain * deformation;
        displacement_left_ -= largest_displacement(step);
    }

    int factorization_limit() const { return settings_.most_factorizations + 20; }

    const NewtonSettings& settings_;
    ContactModel& model_;
    ModelSolver& solver_;
    double largest_move_;
    double displacement_left_ =
        2.5 * largest_move_;          // half a window: what is left for pairs to close
    double damping_ = first_damping;  // times the mean force
    ModelCurvature curvature_;
};

}  // namespace

NewtonResult newton_relax(const NewtonSettings& settings, const NeighborList& candidates,
                          double smallest_diameter, PeriodicCell& cell, Particles& particles) {
    const double window =
        std::min(settings.largest_window * smallest_diameter,
                 window_in_mean_overlaps * mean_overlap_of(candidates, cell, particles));
    ContactModel model(candidates, cell, particles, settings.material, settings.pressure, window);
    if (model.particle_count() == 0) return {};
    ModelSolver solver(model);
    if (solver.operations() > settings.most_operations) return {};
    Mat3 deformation = Mat3::Identity();
    VectorXd displacement = VectorXd::Zero(3 * model.particle_count());
    Descent descent(settings, model, solver, largest_move_in_windows * window);
    const NewtonResult result = descent.run(deformation, displacement);
    if (!result.converged) return result;
    cell = PeriodicCell(
        Mat3(Mat3(deformation * cell.matrix()).triangularView<Eigen::Upper>().toDenseMatrix()));
    for (std::size_t row = 0; row < model.particles().size(); ++row) {
        Vec3& center = particles.spheres[static_cast<std::size_t>(model.particles()[row])].center;
        center += cell.fractional(displacement.segment<3>(3 * static_cast<Eigen::Index>(row)));
    }
    return result;
}

}  // namespace jam
