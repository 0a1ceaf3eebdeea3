// SPDX-License-Identifier: BSD-3-Clause
// Every figure is written and drawn, for ordinary packings and for odd ones.
#include "report/group_figures.h"
#include "report/packing_figures.h"
#include "support/packings.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

namespace jam {
namespace {

using namespace test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

Measurements measured(const Packing& packing) {
    return measure(packing, find_force_network(packing));
}

Table run_of(int records) {
    Table history;
    for (const char* name : {"step", "time", "volume_fraction", "coordination", "coordination_nr",
                             "cundall", "pressure"})
        history.columns.push_back({name, {}});
    for (int k = 0; k < records; ++k)
        for (std::size_t c = 0; c < history.columns.size(); ++c)
            history.columns[c].values.push_back(c < 2 ? 1e4 * k : 0.7 + std::exp(-0.1 * k));
    return history;
}

std::set<std::string> names_of(const std::vector<Figure>& figures) {
    std::set<std::string> names;
    for (const Figure& figure : figures) names.insert(figure.name);
    return names;
}

/// Draws the figures and looks for every file that belongs to them.
void expect_drawn(const std::vector<Figure>& figures) {
    const ScratchFolder folder;
    write_figures(figures, folder.path());
    const Drawing drawing = draw_figures(figures, folder.path());
    if (!drawing.gnuplot_found) GTEST_SKIP() << "gnuplot is not installed";
    EXPECT_THAT(drawing.problems, IsEmpty());
    for (const Figure& figure : figures) {
        EXPECT_THAT(content_of(folder / (figure.name + ".svg")), HasSubstr("</svg>"))
            << figure.name;
        EXPECT_THAT(content_of(folder / (figure.name + ".png")), HasSubstr("IEND")) << figure.name;
        for (const Figure::Data& data : figure.data)
            EXPECT_TRUE(std::filesystem::exists(folder / (data.name + ".csv"))) << data.name;
    }
}

TEST(Figures, OfManySizes) {
    const Packing packing = random_spheres(random_edges(14.0, 2), 900, 6.0, 3);
    const std::vector<Figure> figures = packing_figures(measured(packing), run_of(50));
    EXPECT_EQ(
        names_of(figures),
        (std::set<std::string>{"history", "cumulative_volume", "pair_sizes", "size_coordination",
                               "backbone_sizes", "backbone_larger", "forces", "gaps", "radial"}));
    expect_drawn(figures);
}

TEST(Figures, OfEqualSpheresLeaveOutWhatIsAboutSizes) {
    const std::vector<Figure> figures =
        packing_figures(measured(face_centered_cubic(3, 1.4, 1.0)), {});
    EXPECT_EQ(names_of(figures), (std::set<std::string>{"forces", "radial"}));
    expect_drawn(figures);
}

TEST(Figures, OfAPackingWithoutContacts) {
    expect_drawn(packing_figures(measured(face_centered_cubic(3, 1.6, 1.0)), run_of(1)));
}

TEST(Figures, OfTwoSpheres) {
    const Packing packing = make_packing(Mat3::Identity() * 10.0,
                                         {Vec3(2.0, 2.0, 2.0), Vec3(3.4, 2.0, 2.0)}, {1.0, 2.0});
    expect_drawn(packing_figures(measured(packing), {}));
}

/// A packing's measurements as if its sizes followed this law.
NamedMeasurements of_law(const PowerLaw& law, std::uint64_t seed) {
    const Packing packing = random_spheres(random_edges(12.0, seed), 500, law.size_ratio, seed);
    return {"packing", name_of(SizeDistribution{law}), measured(packing)};
}

TEST(Figures, OfGroups) {
    std::vector<NamedMeasurements> packings;
    for (const double ratio : {3.0, 5.0})
        for (const double alpha : {0.4, 0.8})
            for (const std::uint64_t seed : {1u, 2u})
                packings.push_back(of_law({ratio, alpha}, seed));
    const std::vector<Figure> figures = group_figures(packings, group_packings(packings));
    EXPECT_EQ(figures.size(), 7u);
    expect_drawn(figures);
}

TEST(Figures, OfOneGroupAndOfNone) {
    const std::vector<NamedMeasurements> one = {of_law({3.0, 0.4}, 1)};
    expect_drawn(group_figures(one, group_packings(one)));
    const Packing crystal = face_centered_cubic(3, 1.4, 1.0);
    const std::vector<NamedMeasurements> none = {
        {"crystal", name_of(SizeDistribution{Monodisperse{}}), measured(crystal)}};
    EXPECT_THAT(group_figures(none, group_packings(none)), IsEmpty());
}

TEST(Figures, ATableHoldsEveryPacking) {
    std::vector<NamedMeasurements> packings;
    for (const std::uint64_t seed : {1u, 2u, 3u}) packings.push_back(of_law({4.0, 0.6}, seed));
    const Figure figure = size_coordination_by_alpha_figure(packings, group_packings(packings));
    const std::vector<double>& which = figure.data.front().table.columns.at(2).values;
    EXPECT_THAT(which, Contains(0.0));
    EXPECT_THAT(which, Contains(1.0));
    EXPECT_THAT(which, Contains(2.0));
}

TEST(Figures, AreLeftUndrawnWithoutGnuplot) {
    const ScratchFolder folder;
    const std::vector<Figure> figures =
        packing_figures(measured(face_centered_cubic(3, 1.4, 1.0)), {});
    write_figures(figures, folder.path());
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
    const Drawing drawing = draw_figures(figures, folder.path());
    setenv("PATH", path.c_str(), 1);
    EXPECT_FALSE(drawing.gnuplot_found);
    EXPECT_FALSE(std::filesystem::exists(folder / "forces.svg"));
    EXPECT_TRUE(std::filesystem::exists(folder / "forces.csv"));
}

TEST(Figures, WhatGnuplotDislikesIsToldByFigure) {
    const ScratchFolder folder;
    const std::vector<Figure> figures = {{"broken", "Broken", "", "plot nonsense(\n", {}}};
    write_figures(figures, folder.path());
    const Drawing drawing = draw_figures(figures, folder.path());
    if (!drawing.gnuplot_found) GTEST_SKIP() << "gnuplot is not installed";
    ASSERT_EQ(drawing.problems.size(), 1u);
    EXPECT_THAT(drawing.problems[0], HasSubstr("broken"));
}

}  // namespace
}  // namespace jam
