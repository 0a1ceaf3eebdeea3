// SPDX-License-Identifier: BSD-3-Clause
// Scenes whose pressure, sizes, number, start or damping lie at an end of what can be asked for.
#include "extremes/jamming_run.h"
#include "support/packings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace jam {
namespace {

using test::equal_spheres;
using test::expect_jammed;
using test::expect_refused;
using test::few_spheres;
using test::JammingRun;
using test::JammingRuns;
using test::make_packing;
using test::scene_from;
using testing::HasSubstr;

// --- pressure -----------------------------------------------------------------------------------

class AppliedPressure : public testing::TestWithParam<double> {};

TEST_P(AppliedPressure, IsReachedInBalance) {
    JammingRuns jam;
    expect_jammed(jam(few_spheres, {fmt::format("protocol.pressure={}", GetParam())}), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Extremes, AppliedPressure,
                         testing::Values(1e-9, 1e-8, 1e-7, 1e-5, 1e-3, 1e-2, 1e-1));

TEST(PressureExtremes, ContactsFallToTheIsostaticNumber) {
    JammingRuns jam;
    JammingRun above = jam(few_spheres, {"protocol.pressure=1e-1"});
    EXPECT_GT(above.volume_fraction, 0.8);
    for (const char* pressure : {"1e-2", "1e-3", "1e-5"}) {
        const JammingRun below = jam(few_spheres, {fmt::format("protocol.pressure={}", pressure)});
        EXPECT_LT(below.excess_contacts, above.excess_contacts) << pressure;
        above = below;
    }
    const JammingRun lowest = jam(few_spheres, {"protocol.pressure=1e-8"});
    EXPECT_EQ(lowest.excess_contacts, 0.0);
    EXPECT_LT(lowest.volume_fraction, 0.7);
}

TEST(PressureExtremes, NoPressureIsRefused) {
    JammingRuns jam;
    for (const char* none : {"0", "-1e-6", "nan", "inf"})
        expect_refused(jam(few_spheres, {fmt::format("protocol.pressure={}", none)}),
                       {"protocol.pressure", "above 0"});
}

// --- sizes --------------------------------------------------------------------------------------

/// Ten large spheres and a hundred of diameter 1, in a table beside the scene.
std::string ten_large_ones(const test::ScratchFolder& folder, double size_ratio) {
    std::ofstream table(folder / "sizes.csv");
    table << "diameter\n";
    for (int k = 0; k < 10; ++k) table << size_ratio << "\n";
    for (int k = 0; k < 100; ++k) table << "1\n";
    return fmt::format("[sizes]\nkind = \"table\"\nfile = \"{}\"\n",
                       (folder / "sizes.csv").string());
}

class SizeRatio : public testing::TestWithParam<double> {};

TEST_P(SizeRatio, OfFewSpheresJams) {
    JammingRuns jam;
    const test::ScratchFolder folder;
    expect_jammed(jam(ten_large_ones(folder, GetParam())), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Extremes, SizeRatio, testing::Values(1.0, 10.0, 100.0, 1000.0));

TEST(SizeExtremes, OneSphereThatIsAlmostAllOfTheVolumeIsRefused) {
    JammingRuns jam;
    expect_refused(jam(few_spheres, {"sizes.size_ratio=100"}),
                   {"as wide as its largest sphere", "sizes.count", "sizes.size_ratio"});
}

class Exponent : public testing::TestWithParam<double> {};

TEST_P(Exponent, Jams) {
    JammingRuns jam;
    expect_jammed(
        jam(few_spheres, {fmt::format("sizes.alpha={}", GetParam()), "sizes.size_ratio=5"}), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Extremes, Exponent, testing::Values(-0.5, 0.0, 1.0, 2.0, 3.0, 4.0));

TEST(SizeExtremes, ExponentsBeyondTheEndsAreRefused) {
    JammingRuns jam;
    for (const char* alpha : {"-1.01", "4.01"})
        expect_refused(jam(few_spheres, {fmt::format("sizes.alpha={}", alpha)}),
                       {"sizes.alpha", "from -1 to 4"});
}

TEST(SizeExtremes, DiametersThatDifferInTheirLastBitJamAsEqualOnesDo) {
    JammingRuns jam;
    const test::ScratchFolder folder;
    std::ofstream table(folder / "bits.csv");
    table << "diameter\n";
    for (int k = 0; k < 60; ++k)
        table << fmt::format("{}\n", k % 2 == 0 ? 1.0 : std::nextafter(1.0, 2.0));
    table.close();
    const JammingRun almost = jam(
        fmt::format("[sizes]\nkind = \"table\"\nfile = \"{}\"\n", (folder / "bits.csv").string()));
    const JammingRun equal = jam(equal_spheres);
    expect_jammed(almost, 1e-6);
    expect_jammed(equal, 1e-6);
    EXPECT_NEAR(almost.volume_fraction, equal.volume_fraction, 0.03);
}

// --- number -------------------------------------------------------------------------------------

TEST(NumberExtremes, TenAndThreeJamOneAndTwoAreRefused) {
    JammingRuns jam;
    expect_jammed(jam(equal_spheres, {"sizes.count=10"}), 1e-6);
    expect_jammed(jam(equal_spheres, {"sizes.count=3", "run.seed=2"}), 1e-6);
    // The cell in which one or two equal spheres jam is narrower than one of them.
    for (const char* count : {"sizes.count=1", "sizes.count=2"})
        expect_refused(jam(equal_spheres, {count}), {"cell", "sizes.count"});
    expect_refused(jam(equal_spheres, {"sizes.count=0"}), {"sizes.count", "from 1"});
}

// --- start --------------------------------------------------------------------------------------

TEST(StartExtremes, AlmostEmptyAndDense) {
    JammingRuns jam;
    expect_jammed(jam(few_spheres, {"start.volume_fraction=0.01"}), 1e-6);
    expect_jammed(jam(few_spheres, {"start.volume_fraction=0.4"}), 1e-6);
    expect_refused(jam(few_spheres, {"start.volume_fraction=0.6"}),
                   {"start.volume_fraction = 0.6", "smaller start.volume_fraction"});
    expect_refused(jam(few_spheres, {"start.volume_fraction=0.61"}), {"at most 0.6"});
}

/// Points of a box of the given sides, spread evenly but without order (Halton, 1960).
std::vector<Vec3> spread_points(int count, const Vec3& sides) {
    const auto radical_inverse = [](int index, int base) {
        double out = 0.0;
        for (double share = 1.0 / base; index > 0; index /= base, share /= base)
            out += share * (index % base);
        return out;
    };
    std::vector<Vec3> points;
    for (int k = 1; k <= count; ++k)
        points.push_back(sides.cwiseProduct(
            Vec3(radical_inverse(k, 2), radical_inverse(k, 3), radical_inverse(k, 5))));
    return points;
}

TEST(StartExtremes, CoincidentCentersAreRefusedBeforeAnythingIsWritten) {
    JammingRuns jam;
    std::vector<Vec3> points = spread_points(60, Vec3::Constant(4.0));
    points[41] = points[17];
    const auto packing = make_packing(Mat3::Identity() * 4.0, points, std::vector<double>(60, 1.0));
    const JammingRun run = jam(scene_from(jam.write_packing(packing)));
    expect_refused(run, {"start.packing", "18 and 42", "same center"});
    EXPECT_FALSE(run.left_files);
}

TEST(StartExtremes, CentersThatAlmostCoincideJam) {
    JammingRuns jam;
    std::vector<Vec3> points = spread_points(60, Vec3::Constant(4.0));
    points[41] = points[17] + Vec3(1e-14, 0.0, 0.0);
    const auto packing = make_packing(Mat3::Identity() * 4.0, points, std::vector<double>(60, 1.0));
    expect_jammed(jam(scene_from(jam.write_packing(packing))), 1e-6);
}

TEST(StartExtremes, SpheresThreeTimesTooManyForTheCellAreRelaxed) {
    JammingRuns jam;
    const auto packing =
        make_packing(Mat3::Identity() * 2.5, spread_points(60, Vec3::Constant(2.5)),
                     std::vector<double>(60, 1.0));
    expect_jammed(jam(scene_from(jam.write_packing(packing))), 1e-6);
}

/// Sixty unit spheres in a cell that is tilted by `tilts` (xy, xz, yz) of its edges.
Packing tilted(const Vec3& tilts) {
    Mat3 h = Mat3::Identity() * 5.0;
    h(0, 1) = tilts[0] * 5.0;
    h(0, 2) = tilts[1] * 5.0;
    h(1, 2) = tilts[2] * 5.0;
    std::vector<Vec3> points = spread_points(60, Vec3::Constant(1.0));
    for (Vec3& point : points) point = h * point;
    return make_packing(h, points, std::vector<double>(60, 1.0));
}

TEST(StartExtremes, CellsAtAndFarBeyondTheReductionLimitJam) {
    for (const Vec3& tilts :
         {Vec3(0.5, -0.5, 0.5), Vec3(-0.5, 0.5, -0.5), Vec3(30.5, -40.5, 7.5)}) {
        JammingRuns jam;
        expect_jammed(jam(scene_from(jam.write_packing(tilted(tilts)))), 1e-6);
    }
}

TEST(StartExtremes, ASphereAsLargeAsTheCellIsRefusedBeforeAnythingIsWritten) {
    for (const double diameter : {3.0, 4.0}) {
        JammingRuns jam;
        std::vector<Vec3> points = spread_points(20, Vec3::Constant(3.0));
        std::vector<double> diameters(20, 0.2);
        diameters[0] = diameter;
        const auto packing = make_packing(Mat3::Identity() * 3.0, points, diameters);
        const JammingRun run = jam(scene_from(jam.write_packing(packing)));
        expect_refused(run, {"start.packing", "wider than its spheres"});
        EXPECT_FALSE(run.left_files);
    }
}

// --- damping ------------------------------------------------------------------------------------

class Damping : public testing::TestWithParam<double> {};

TEST_P(Damping, LeavesTheJammedStateAsItIs) {
    JammingRuns jam;
    for (const char* size_ratio : {"1", "8"})
        expect_jammed(
            jam(few_spheres, {fmt::format("contact.damping={}", GetParam()),
                              fmt::format("sizes.size_ratio={}", size_ratio), "sizes.alpha=2"}),
            1e-6);
}

INSTANTIATE_TEST_SUITE_P(Extremes, Damping, testing::Values(0.0, 50.0, 1e4));

TEST(DampingExtremes, NphStaysBoundedWithTheAutomaticStep) {
    for (const char* damping : {"0", "50"}) {
        JammingRuns jam;
        const JammingRun run =
            jam(few_spheres, {"protocol.kind=nph", "protocol.pressure=1e-2", "stop.max_steps=5000",
                              fmt::format("contact.damping={}", damping)});
        EXPECT_EQ(run.status, 3) << run.said;
        EXPECT_EQ(run.not_a_number, "");
        EXPECT_THAT(run.said, HasSubstr("stop.max_steps"));
    }
}

}  // namespace
}  // namespace jam
