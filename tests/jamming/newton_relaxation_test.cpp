// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/newton_relaxation.h"

#include "jamming/contact_model.h"
#include "jamming/model_solver.h"
#include "jamming/relax_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

/// A dense state some way from rest, with its lists.
struct Dense {
    explicit Dense(ContactLaw law = ContactLaw::hooke) {
        scene.sizes.distribution = Monodisperse{};
        scene.sizes.count = 120;
        scene.contact.law = law;
        scene.start.volume_fraction = 0.3;
        state = start_state(scene);
        // Shrunk, and tilted, until spheres overlap on average a little.
        Mat3 h = state.cell.matrix() * std::cbrt(0.3 / 0.72);
        h(0, 1) = 0.2;
        h(0, 2) = -0.1;
        h(1, 2) = 0.15;
        state.cell = PeriodicCell(h);
        lists.hierarchy.group(state.particles);
        renew_lists(lists, state.cell, {}, {}, state.particles);
    }
    ContactModel model() const {
        return {lists.candidates, state.cell, state.particles, scene.contact, pressure, 0.05};
    }

    Scene scene;
    double pressure = 1e-2;
    JamState state;
    VerletLists lists{std::vector<double>(120, 1.0), ListSettings{}};
};

class ContactModelTest : public testing::TestWithParam<ContactLaw> {};

TEST_P(ContactModelTest, SlopeIsTheDerivativeOfTheEnthalpyAndCurvatureThatOfTheSlope) {
    const Dense dense(GetParam());
    const ContactModel model = dense.model();
    const Eigen::Index count = model.unknown_count();
    Eigen::VectorXd slope;
    ModelCurvature curvature;
    model.evaluate(Eigen::VectorXd::Zero(count), 0.0, slope, &curvature);
    EXPECT_LT((slope - model.now().slope).norm(), 1e-12 * slope.norm());
    for (const Eigen::Index unknown :
         {Eigen::Index{0}, Eigen::Index{100}, count - 6, count - 5, count - 3, count - 1}) {
        const double small = 1e-6;
        Eigen::VectorXd step = Eigen::VectorXd::Zero(count);
        step[unknown] = small;
        ContactModel up = model;
        up.move(step);
        ContactModel down = model;
        down.move(-step);
        const double by_difference = (up.now().enthalpy - down.now().enthalpy) / (2.0 * small);
        ASSERT_GT(std::abs(slope[unknown]), 1e-6);
        EXPECT_NEAR(by_difference, slope[unknown], 1e-6 * std::abs(slope[unknown]) + 1e-9);
        const Eigen::VectorXd column = (up.now().slope - down.now().slope) / (2.0 * small);
        if (unknown >= count - cell_component_count) {
            const Eigen::Index component = unknown - (count - cell_component_count);
            const Eigen::VectorXd border = curvature.border.col(component);
            EXPECT_LT((column.head(count - 6) - border).norm(), 2e-2 * border.norm());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Laws, ContactModelTest,
                         testing::Values(ContactLaw::hooke, ContactLaw::hertz));

TEST(ModelSolver, SolvesWhatItSays) {
    const Dense dense;
    const ContactModel model = dense.model();
    ModelSolver solver(model);
    Eigen::VectorXd slope;
    ModelCurvature curvature;
    const Eigen::VectorXd origin = Eigen::VectorXd::Zero(model.unknown_count());
    const double mu = 10.0;
    model.evaluate(origin, mu, slope, &curvature);
    Eigen::VectorXd step;
    ASSERT_TRUE(solver.solve(curvature, mu, slope, step));
    // The model is quadratic as long as no contact opens or closes: a small share of the step.
    Eigen::VectorXd after;
    const double share = 1e-6;
    model.evaluate(share * step, mu, after, nullptr);
    EXPECT_LT((after - (1.0 - share) * slope).norm(), 1e-3 * share * slope.norm());
    EXPECT_GT(solver.operations(), 0.0);
    EXPECT_EQ(solver.factorizations(), 1);
}

TEST(NewtonRelaxation, EndsAtAMinimumFromARelaxedState) {
    Dense dense;
    RelaxSettings settings{.material = dense.scene.contact,
                           .pressure = Mat3::Identity() * dense.pressure};
    RelaxScratch scratch(std::vector<double>(120, 1.0), ListSettings{});
    begin_relaxation(dense.state, settings, scratch);
    for (int step = 0; step < 20'000 && !(scratch.cundall() < 1e-5); ++step)
        relax_step(dense.state, settings, scratch);
    ASSERT_LT(scratch.cundall(), 1e-5);
    const NewtonResult result =
        newton_relax({.material = dense.scene.contact, .pressure = dense.pressure},
                     scratch.lists.candidates, 1.0, dense.state.cell, dense.state.particles);
    EXPECT_TRUE(result.tried);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.cundall, 1e-8);
    EXPECT_LT(result.pressure_error, 1e-8);
    dense.state.list_reference = {};
    begin_relaxation(dense.state, settings, scratch);
    EXPECT_LT(scratch.cundall(), 1e-7);
    EXPECT_LT((dense.state.pressure - settings.pressure).cwiseAbs().maxCoeff(),
              1e-7 * dense.pressure);
}

TEST(NewtonRelaxation, LeavesAloneWhatWouldTakeTooLong) {
    Dense dense;
    const Vec3 before = dense.state.particles.spheres[0].center;
    const NewtonResult result = newton_relax(
        {.material = dense.scene.contact, .pressure = dense.pressure, .most_operations = 1.0},
        dense.lists.candidates, 1.0, dense.state.cell, dense.state.particles);
    EXPECT_FALSE(result.tried);
    EXPECT_EQ(result.factorizations, 0);
    EXPECT_EQ(dense.state.particles.spheres[0].center, before);
}

TEST(NewtonRelaxation, LeavesNoTraceWhereItReachesNoMinimum) {
    Dense dense;
    const JamState before = dense.state;
    const NewtonResult result = newton_relax(
        {.material = dense.scene.contact, .pressure = dense.pressure, .most_factorizations = 3},
        dense.lists.candidates, 1.0, dense.state.cell, dense.state.particles);
    EXPECT_TRUE(result.tried);
    EXPECT_FALSE(result.converged);
    EXPECT_GE(result.factorizations, 3);
    EXPECT_EQ(dense.state.cell.matrix(), before.cell.matrix());
    for (std::size_t i = 0; i < before.particles.spheres.size(); ++i)
        EXPECT_EQ(dense.state.particles.spheres[i].center, before.particles.spheres[i].center);
}

TEST(NewtonRelaxation, GivesUpEarlyWhereParticlesAreAboutToBuckle) {
    Dense dense;
    const NewtonResult result = newton_relax(
        {.material = dense.scene.contact, .pressure = dense.pressure, .most_factorizations = 1000},
        dense.lists.candidates, 1.0, dense.state.cell, dense.state.particles);
    EXPECT_FALSE(result.converged);
    EXPECT_EQ(result.steps, 2);
    EXPECT_LT(result.factorizations, 100);
}

}  // namespace
}  // namespace jam
