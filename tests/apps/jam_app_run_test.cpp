// SPDX-License-Identifier: BSD-3-Clause
// jam_app run as a user meets it: files, exit statuses, stopping and going on.
#include "packing/packing_file.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace jam {
namespace {

namespace fs = std::filesystem;
using test::ProgramRun;

class JamAppRun : public testing::Test {
  protected:
    void SetUp() override {
        std::ofstream(scene())
            << "[sizes]\nkind = \"power-law\"\nsize_ratio = 2\nalpha = 0.5\ncount = 250\n"
               "[protocol]\nkind = \"nph\"\npressure = 1e-2\nmasses = \"diameter\"\n"
               "[stop]\ncundall = 1e-4\nkinetic_energy = 1e-8\nvolume_fraction_change = 1e-5\n"
               "coordination_change = 0.02\nwindow = 2000\nmax_steps = 200000\n"
               "[run]\nrecord_interval = 500\n";
    }
    std::string scene() const { return (folder_.path() / "scene.toml").string(); }
    std::string out(const char* name) const { return (folder_.path() / name).string(); }

    ProgramRun run(const char* name, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"run", scene(), "--out", out(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::run_program(WIDEJAM_JAM_APP, arguments);
    }

    static std::string content(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    test::ScratchFolder folder_;
};

TEST_F(JamAppRun, RejamWithoutRattlersSaysWhatHasChanged) {
    ASSERT_EQ(run("jammed").status, 0);
    const std::string packing = out("jammed") + "/packing.h5";
    const ProgramRun again = test::run_program(
        WIDEJAM_JAM_APP, {"rejam", packing, "--without-rattlers", "--out", out("again")});
    ASSERT_EQ(again.status, 0) << again.out << again.err;
    EXPECT_NE(again.out.find("coordination_nr"), std::string::npos) << again.out;
    const Packing backbone = load_packing(fs::path(out("again")) / "packing.h5");
    EXPECT_LT(backbone.size(), 250);
    EXPECT_GT(backbone.size(), 150);
    // A second one into the same folder would overwrite the first.
    EXPECT_EQ(test::run_program(WIDEJAM_JAM_APP, {"rejam", packing, "--out", out("again")}).status,
              2);
}

TEST_F(JamAppRun, ConvergesAndLeavesWhatItPromises) {
    const ProgramRun jammed = run("jammed");
    ASSERT_EQ(jammed.status, 0) << jammed.out << jammed.err;
    for (const char* file : {"packing.h5", "checkpoint.h5", "record.jsonl", "run.log"})
        EXPECT_TRUE(fs::exists(fs::path(out("jammed")) / file)) << file;
    const Packing packing = load_packing(fs::path(out("jammed")) / "packing.h5");
    EXPECT_EQ(packing.size(), 250);
    EXPECT_NE(packing.provenance.scene.find("size_ratio"), std::string::npos);
    EXPECT_NE(packing.provenance.verdict.find("\"converged\":true"), std::string::npos);
    // The last record and what analyze_app computes from the file are the same numbers.
    std::istringstream lines(content(fs::path(out("jammed")) / "record.jsonl"));
    std::string line;
    std::string last;
    while (std::getline(lines, line)) last = line;
    const auto record = nlohmann::json::parse(last);
    const ProgramRun stats =
        test::run_program(WIDEJAM_ANALYZE_APP,
                          {"stats", "--json", (fs::path(out("jammed")) / "packing.h5").string()});
    ASSERT_EQ(stats.status, 0);
    const auto measured = nlohmann::json::parse(stats.out);
    for (const char* key : {"volume_fraction", "coordination", "coordination_nr", "cundall"})
        EXPECT_NEAR(measured[key].get<double>(), record[key].get<double>(),
                    1e-9 * record[key].get<double>())
            << key;
}

TEST_F(JamAppRun, StoppedAndResumedEqualsUninterrupted) {
    ASSERT_EQ(run("whole", {"--set", "stop.max_steps=2300"}).status, 3);
    const ProgramRun stopped = run("parts", {"--set", "stop.max_steps=1234"});
    ASSERT_EQ(stopped.status, 3);
    EXPECT_NE((stopped.out + stopped.err).find("--resume"), std::string::npos);
    ASSERT_EQ(run("parts", {"--set", "stop.max_steps=2300", "--resume", "--threads", "3"}).status,
              3);
    const Packing whole = load_packing(fs::path(out("whole")) / "packing.h5");
    const Packing parts = load_packing(fs::path(out("parts")) / "packing.h5");
    EXPECT_EQ(whole.positions, parts.positions);
    EXPECT_EQ(whole.velocities, parts.velocities);
    EXPECT_EQ(whole.cell.matrix(), parts.cell.matrix());
    const auto count_lines = [&](const char* name) {
        const std::string text = content(fs::path(out(name)) / "record.jsonl");
        return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_EQ(count_lines("whole"), 5);
    EXPECT_EQ(count_lines("parts"), 5);
}

TEST_F(JamAppRun, WhatHasConvergedBetweenTwoRecordsStaysWhereItIs) {
    const std::vector<std::string> quasistatic = {"--set", "protocol.kind=quasistatic", "--set",
                                                  "run.record_interval=1000000"};
    ASSERT_EQ(run("jammed", quasistatic).status, 0);
    const fs::path file = fs::path(out("jammed")) / "packing.h5";
    const Packing before = load_packing(file);
    std::vector<std::string> resumed = quasistatic;
    resumed.emplace_back("--resume");
    ASSERT_EQ(run("jammed", resumed).status, 0);
    const Packing after = load_packing(file);
    EXPECT_EQ(after.step, before.step);
    EXPECT_EQ(after.positions, before.positions);
}

TEST_F(JamAppRun, NamesTheOneCriterionThatIsMissing) {
    const auto run_to = [&](const char* max_steps, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"--set", "protocol.kind=quasistatic",
                                              "--set", "stop.stability=false",
                                              "--set", "stop.cundall=1e-300",
                                              "--set", std::string("stop.max_steps=") + max_steps};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run("waits", arguments);
    };
    ASSERT_EQ(run_to("6000", {}).status, 3);
    const ProgramRun resumed = run_to("7000", {"--resume"});
    ASSERT_EQ(resumed.status, 3);
    EXPECT_NE(resumed.out.find("1 of 2 criteria, cundall "), std::string::npos) << resumed.out;
}

TEST_F(JamAppRun, BadInputWritesNothing) {
    const ProgramRun bad = run("bad", {"--set", "sizes.size_ratio=-3"});
    EXPECT_EQ(bad.status, 2);
    EXPECT_NE(bad.err.find("sizes.size_ratio"), std::string::npos);
    EXPECT_FALSE(fs::exists(out("bad")));
    const ProgramRun nothing = run("none", {"--resume"});
    EXPECT_EQ(nothing.status, 2);
    EXPECT_FALSE(fs::exists(out("none")));
}

TEST_F(JamAppRun, DoesNotWriteOverARun) {
    ASSERT_EQ(run("once", {"--set", "stop.max_steps=600"}).status, 3);
    const std::string before = content(fs::path(out("once")) / "packing.h5");
    const ProgramRun again = run("once", {"--set", "stop.max_steps=600"});
    EXPECT_EQ(again.status, 2);
    EXPECT_NE(again.err.find("--resume"), std::string::npos);
    EXPECT_EQ(content(fs::path(out("once")) / "packing.h5"), before);
    const ProgramRun other = run("once", {"--resume", "--set", "protocol.pressure=1e-3"});
    EXPECT_EQ(other.status, 2);
    EXPECT_NE(other.err.find("protocol.pressure"), std::string::npos);
}

}  // namespace
}  // namespace jam
