// SPDX-License-Identifier: BSD-3-Clause
// analyze_app compare and convert as a user runs them.
#include "packing/packing_io.h"
#include "support/data_folders.h"
#include "support/packings.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace jam {
namespace {

using namespace test;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string monodisperse = packing_folder + "lammps_lambda1_p1e-3.dump";
const std::string power_law = packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump";

ProgramRun analyze(const std::vector<std::string>& arguments) {
    return run_program(WIDEJAM_ANALYZE_APP, arguments);
}

TEST(AnalyzeAppCompare, TwoPackings) {
    const ProgramRun run = analyze({"compare", monodisperse, power_law, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    const json found = json::parse(run.out);
    const json& phi = found["numbers"]["volume_fraction"];
    EXPECT_NEAR(phi["a"]["value"].get<double>(), 0.6306199008, 1e-9);
    EXPECT_NEAR(phi["b"]["value"].get<double>(), 0.7187972909, 1e-9);
    EXPECT_NEAR(phi["difference"].get<double>(), 0.0881773901, 1e-9);
    EXPECT_TRUE(phi["p_value"].is_null());
    EXPECT_TRUE(phi["a"]["error"].is_null());
    const json& contacts = found["distributions"]["backbone_contact_counts"];
    EXPECT_LT(contacts["p_value"], 1e-9);
    EXPECT_EQ(contacts["count_a"], 9631);
    EXPECT_EQ(found["a"], json::array({monodisperse}));
}

TEST(AnalyzeAppCompare, TwoFolders) {
    const ScratchFolder scratch;
    for (const char* group : {"sparse", "dense"}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const int count = group[0] == 's' ? 300 : 450;
            const Packing packing = random_spheres(Mat3::Identity() * 8.0, count, 2.0,
                                                   seed + static_cast<std::uint64_t>(count));
            const auto folder = scratch / group / std::to_string(seed);
            std::filesystem::create_directories(folder);
            write_packing(packing, folder / "packing.h5");
            write_packing(packing, folder / "checkpoint.h5");  // not a packing to compare
        }
    }
    const std::string sparse = scratch / "sparse";
    const std::string dense = scratch / "dense";
    const ProgramRun run = analyze({"compare", sparse, dense, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const json found = json::parse(run.out);
    EXPECT_EQ(found["a"].size(), 3u);
    EXPECT_LT(found["numbers"]["coordination"]["p_value"], 0.01);
    EXPECT_GT(found["numbers"]["coordination"]["a"]["error"], 0.0);
    const ProgramRun told = analyze({"compare", sparse, dense});
    EXPECT_THAT(told.out, HasSubstr("3 packings"));
    EXPECT_THAT(told.out, HasSubstr("coordination_nr"));
    EXPECT_THAT(told.out, HasSubstr("backbone_forces"));
}

TEST(AnalyzeAppCompare, RefusesWhatItCannotUse) {
    const ScratchFolder scratch;
    for (const std::string& bad : {(scratch / "absent.h5").string(), scratch.path().string()}) {
        const ProgramRun run = analyze({"compare", power_law, bad});
        EXPECT_EQ(run.status, 2);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_THAT(run.err, HasSubstr(bad));
    }
    EXPECT_EQ(analyze({"compare", power_law}).status, 2);
}

class AnalyzeConvert : public testing::TestWithParam<const char*> {};

TEST_P(AnalyzeConvert, KeepsCentersAndDiameters) {
    const ScratchFolder scratch;
    const std::string there = scratch / (std::string("there") + GetParam());
    const std::string back = scratch / "back.h5";
    ASSERT_EQ(analyze({"convert", power_law, there}).status, 0);
    ASSERT_EQ(analyze({"convert", there, back}).status, 0);
    const json before = json::parse(analyze({"stats", power_law, "--json"}).out);
    const json after = json::parse(analyze({"stats", back, "--json"}).out);
    EXPECT_EQ(after["contact_count"], before["contact_count"]);
    EXPECT_EQ(after["rattler_count"], before["rattler_count"]);
    EXPECT_NEAR(after["cundall"].get<double>(), before["cundall"].get<double>(), 1e-10);
    EXPECT_NEAR(after["volume_fraction"].get<double>(), before["volume_fraction"].get<double>(),
                1e-14);
}

INSTANTIATE_TEST_SUITE_P(Formats, AnalyzeConvert,
                         testing::Values(".h5", ".dump", ".data", ".xyz", ".csv"));

TEST(AnalyzeAppConvert, SaysWhatIsLost) {
    const ScratchFolder scratch;
    const ProgramRun run = analyze({"convert", power_law, scratch / "packing.csv"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_EQ(run.err, what_is_lost(read_packing(power_law), scratch / "packing.csv") +
                           (run.err.empty() ? "" : "\n"));
    const ProgramRun ours = analyze({"convert", power_law, scratch / "packing.h5"});
    EXPECT_THAT(ours.err, IsEmpty());
}

TEST(AnalyzeAppConvert, RefusesWhatItCannotUse) {
    const ScratchFolder scratch;
    const ProgramRun unknown = analyze({"convert", power_law, scratch / "packing.docx"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("packing.docx"));
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
    const std::string absent = scratch / "absent.h5";
    EXPECT_EQ(analyze({"convert", absent, scratch / "b.h5"}).status, 2);
}

}  // namespace
}  // namespace jam
