// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/trade.h"

#include "jamming/scene_file.h"
#include "support/scratch_folder.h"
#include "sweep/trade_figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

namespace jam {
namespace {

TradeResult result(double phi, double coordination, double evaluations) {
    TradeResult out;
    out.statistics.volume_fraction = phi;
    out.statistics.coordination_nr = coordination;
    out.evaluations = evaluations;
    out.converged = true;
    return out;
}

TEST(Trade, ErrorsAreTakenSeedBySeedAndTheFrontIsWhatNothingBeats) {
    const std::vector<TradeChoice> choices = {
        {"best", {}}, {"near", {}}, {"quick", {}}, {"bad", {}}};
    // Seeds differ by more than the choices do.
    const std::vector<TradeResult> results = {
        result(0.700, 6.02, 1000), result(0.701, 6.01, 400),  result(0.704, 5.9, 10),
        result(0.706, 5.8, 500),   result(0.680, 6.03, 1200), result(0.683, 6.02, 600),
        result(0.684, 5.9, 30),    result(0.688, 5.8, 700),
    };
    const std::vector<TradePoint> points = trade_points(choices, results);
    ASSERT_EQ(points.size(), 4u);
    EXPECT_EQ(points[0].volume_fraction.mean, 0.0);
    EXPECT_NEAR(points[1].volume_fraction.mean, 0.002, 1e-12);
    EXPECT_NEAR(points[1].volume_fraction.error, 0.001, 1e-12);
    EXPECT_NEAR(points[2].evaluations.mean, 20.0, 1e-12);
    EXPECT_EQ(points[3].seeds, 2);
    EXPECT_EQ(points[3].converged, 2);
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(points[k].front_of_volume_fraction) << k;
    EXPECT_FALSE(points[3].front_of_volume_fraction);
    EXPECT_FALSE(points[3].front_of_coordination);
}

TEST(Trade, OneSeedHasNoScatter) {
    const std::vector<TradeChoice> choices = {{"best", {}}, {"other", {}}};
    const std::vector<TradeResult> results = {result(0.7, 6, 10), result(0.6, 6, 1)};
    EXPECT_TRUE(std::isnan(trade_points(choices, results)[1].volume_fraction.error));
}

TEST(Trade, EveryChoiceIsASceneOfItsOwn) {
    const test::ScratchFolder scratch;
    const auto file = scratch.path() / "scene.toml";
    std::ofstream(file)
        << "[sizes]\nkind = \"power-law\"\nsize_ratio = 2\nalpha = 0.5\ncount = 50\n"
           "[protocol]\npressure = 1e-4\n[run]\nseed = 7\n";
    const std::vector<TradeChoice> choices = trade_choices(read_scene(file));
    const std::vector<SweepRun> runs = trade_runs(file, {}, choices, 2, scratch.path() / "out");
    ASSERT_EQ(runs.size(), 2 * choices.size());
    std::set<std::string> texts, names;
    for (const SweepRun& run : runs) {
        names.insert(run.name);
        Scene scene = run.scene;
        scene.run.output.clear();
        scene.protocol.accuracy = Accuracy::standard;  // a name for what differs otherwise
        texts.insert(scene_text(scene));
    }
    EXPECT_EQ(names.size(), runs.size());
    EXPECT_EQ(texts.size(), runs.size());
    EXPECT_EQ(runs.front().scene.protocol.accuracy, Accuracy::paper);
    EXPECT_EQ(runs.back().scene.run.seed, 8u);
    // 1e-1 would be another material; 1e-3 and 1e-5 are tried.
    EXPECT_THAT(names, testing::Contains("pressure*10_seed=7"));
    EXPECT_THAT(names, testing::Not(testing::Contains("pressure*1000_seed=7")));
}

TEST(Trade, TableAndFigureHoldEveryPoint) {
    const std::vector<TradeChoice> choices = {{"best", {}}, {"other", {}}};
    const std::vector<TradeResult> results = {result(0.7, 6, 10), result(0.6, 5, 1)};
    const std::vector<TradePoint> points = trade_points(choices, results);
    const std::string csv = trade_csv(points);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
    EXPECT_NE(csv.find("\"other\",1,1,"), std::string::npos);
    EXPECT_EQ(trade_figure(points).data.at(0).table.columns.at(0).values.size(), 2u);
}

}  // namespace
}  // namespace jam
