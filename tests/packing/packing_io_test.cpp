// SPDX-License-Identifier: BSD-3-Clause
#include "packing/packing_io.h"

#include "support/example_packings.h"
#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace jam {
namespace {

using namespace jam::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(PackingIo, EveryFormatGivesBackDiametersPositionsAndCell) {
    const ScratchFolder folder;
    const Packing saved = example_packing(300);
    for (const std::string_view name : {"a.h5", "a.dump", "a.data", "a.xyz", "a.csv"}) {
        write_packing(saved, folder / name);
        const Packing read = read_packing(folder / name);
        EXPECT_EQ(read.diameters, saved.diameters) << name;
        EXPECT_EQ(read.positions, saved.positions) << name;
        EXPECT_EQ(read.ids, saved.ids) << name;
        EXPECT_TRUE(read.cell.matrix().isApprox(saved.cell.matrix(), 1e-15)) << name;
    }
}

TEST(PackingIo, SaysWhatIsLostAndNothingElseIs) {
    const ScratchFolder folder;
    const Packing packing = example_packing(20);
    EXPECT_EQ(what_is_lost(packing, "a.h5"), "");
    EXPECT_THAT(what_is_lost(packing, "a.dump"),
                AllOf(HasSubstr("a.dump: a LAMMPS dump does not hold the time"),
                      HasSubstr("density"), Not(HasSubstr("step")), HasSubstr("pressure")));
    EXPECT_THAT(what_is_lost(packing, "a.data"),
                AllOf(HasSubstr("step"), HasSubstr("stiffness"), Not(HasSubstr("density"))));
    EXPECT_THAT(what_is_lost(packing, "a.xyz"),
                AllOf(HasSubstr("density"), Not(HasSubstr("step")), Not(HasSubstr("time"))));
    EXPECT_THAT(what_is_lost(packing, "a.csv"),
                AllOf(HasSubstr("step"), HasSubstr("time"), HasSubstr("scene")));
}

TEST(PackingIo, ABarePackingLosesNothingAnywhere) {
    Packing packing;
    packing.positions = {Vec3(0.5, 0.5, 0.5)};
    packing.diameters = {1.0};
    packing.ids = {1};
    for (const char* name : {"a.h5", "a.dump", "a.data", "a.xyz", "a.csv"})
        EXPECT_EQ(what_is_lost(packing, name), "");
    packing.ids = {0};
    EXPECT_THAT(what_is_lost(packing, "a.data"), HasSubstr("1 is added to each"));
    EXPECT_EQ(what_is_lost(packing, "a.xyz"), "");
    Mat3 h = Mat3::Identity();
    h(0, 1) = 0.75;
    packing.cell = PeriodicCell(h);
    EXPECT_THAT(what_is_lost(packing, "a.data"), HasSubstr("reduced"));
}

TEST(PackingIo, KnowsContentWhereTheNameDoesNotSay) {
    const ScratchFolder folder;
    const Packing saved = example_packing(5);
    for (const char* name : {"a.h5", "a.dump"}) {
        write_packing(saved, folder / name);
        std::filesystem::rename(folder / name, folder / "dump.1000");
        EXPECT_EQ(read_packing(folder / "dump.1000").positions, saved.positions);
    }
}

TEST(PackingIo, ASpoiltTextIsReadOrRefusedButNeverWorse) {
    const ScratchFolder folder;
    for (const std::string_view name : {"a.dump", "a.data", "a.xyz", "a.csv"}) {
        write_packing(example_packing(3), folder / name);
        const std::string whole = content_of(folder / name);
        const std::string spoilers("\n -x9\0\"", 7);
        int refused = 0;
        for (std::size_t place = 0; place < whole.size(); ++place) {
            std::string spoilt = whole;
            spoilt[place] = spoilers[place % spoilers.size()];
            std::ofstream(folder / name, std::ios::binary) << spoilt;
            refused += refusal_of([&] { read_packing(folder / name); }).empty() ? 0 : 1;
        }
        EXPECT_GT(refused, 50) << name;
    }
}

TEST(PackingIo, NamesTheFormatsWhenThereIsNone) {
    const Packing packing = example_packing(5);
    const auto one_of = HasSubstr("must be .h5, .dump, .data, .xyz or .csv");
    EXPECT_THAT(refusal_of([&] { write_packing(packing, "packing.gsd"); }), one_of);
    EXPECT_THAT(refusal_of([&] { what_is_lost(packing, "packing"); }), one_of);
    EXPECT_THAT(refusal_of([&] { read_packing("absent.gsd"); }), one_of);
    EXPECT_THAT(refusal_of([&] { read_packing("absent.csv"); }), HasSubstr("absent.csv"));
}

}  // namespace
}  // namespace jam
