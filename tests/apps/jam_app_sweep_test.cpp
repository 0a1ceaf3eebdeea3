// SPDX-License-Identifier: BSD-3-Clause
// jam_app sweep as a user meets it.
#include "support/run_program.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace jam {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::ProgramRun;
using testing::HasSubstr;
using testing::Not;

class JamAppSweep : public testing::Test {
  protected:
    void write(const std::string& grid, const std::string& more = "") const {
        std::ofstream(sweep()) << "[grid]\n"
                               << grid << "\n[sweep]\noutput = \"" << out().string()
                               << "\"\n[sizes]\nkind = \"monodisperse\"\ncount = 60\n"
                                  "[protocol]\nkind = \"nph\"\npressure = 1e-2\n"
                                  "[stop]\ncundall = 1e-2\nkinetic_energy = 1e-3\nwindow = 100\n"
                                  "pressure = 0.5\nvolume_fraction_change = 0.1\n"
                                  "coordination_change = 10\n"
                                  "[run]\nrecord_interval = 100\n"
                               << more;
    }
    std::string sweep() const { return (folder_.path() / "many.toml").string(); }
    fs::path out() const { return folder_.path() / "out"; }
    ProgramRun run(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"sweep", sweep()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::run_program(WIDEJAM_JAM_APP, arguments);
    }

    test::ScratchFolder folder_;
};

TEST_F(JamAppSweep, DoesEveryRunOnce) {
    write("run.seed = [1, 2, 3]");
    const ProgramRun first = run();
    ASSERT_EQ(first.status, 0) << first.out << first.err;
    EXPECT_THAT(first.out,
                HasSubstr("3 runs: 3 converged, 0 running, 0 stopped, 0 failed, 0 left"));
    for (const char* name : {"seed=1", "seed=2", "seed=3"})
        EXPECT_TRUE(fs::exists(out() / name / "packing.h5")) << name;
    const auto before = fs::last_write_time(out() / "seed=2" / "packing.h5");
    write("run.seed = [1, 2, 3, 4]");
    const ProgramRun again = run();
    ASSERT_EQ(again.status, 0) << again.out << again.err;
    EXPECT_THAT(again.out, HasSubstr("4 runs, 3 of them done"));
    EXPECT_THAT(again.out, Not(HasSubstr("started    seed=2")));
    EXPECT_EQ(fs::last_write_time(out() / "seed=2" / "packing.h5"), before);
}

TEST_F(JamAppSweep, ListsACommandForEachRunThatDoesThatRun) {
    write("sizes.count = [50, 60]\nrun.seed = [1, 2]");
    const ProgramRun list = run({"--list"});
    ASSERT_EQ(list.status, 0);
    EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), 4);
    EXPECT_THAT(list.out, HasSubstr("jam_app sweep " + sweep() + " --only count=60_seed=1\n"));
    EXPECT_FALSE(fs::exists(out()));
    ASSERT_EQ(run({"--only", "count=60_seed=1"}).status, 0);
    EXPECT_TRUE(fs::exists(out() / "count=60_seed=1" / "converged"));
    EXPECT_FALSE(fs::exists(out() / "count=50_seed=1"));
    const ProgramRun unknown = run({"--only", "count=70"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("--list"));
}

TEST_F(JamAppSweep, GoesOnWithRunsThatALimitHasStopped) {
    write("run.seed = [1, 2]\nstop.max_steps = [100]\nstop.cundall=[1e-2]");
    const ProgramRun limited = run();
    EXPECT_EQ(limited.status, 3) << limited.out << limited.err;
    EXPECT_THAT(limited.out, HasSubstr("2 stopped"));
    const std::string name = "seed=1_max_steps=100_cundall=0.01";
    EXPECT_TRUE(fs::exists(out() / name / "checkpoint.h5"));
    EXPECT_FALSE(fs::exists(out() / name / "converged"));
    ASSERT_EQ(run({"--only", name}).status, 3);
    EXPECT_THAT(content_of(out() / name / "run.log"), HasSubstr("from step 100"));
}

TEST_F(JamAppSweep, SavesTheRunsAtASignal) {
    write("run.seed = [1, 2, 3, 4, 5, 6, 7, 8]", "checkpoint_interval = 1000000\n");
    std::ofstream(sweep(), std::ios::app) << "\n";
    std::string text = content_of(sweep());
    text.replace(text.find("cundall = 1e-2"), 14, "cundall = 1e-300");
    std::ofstream(sweep()) << text;
    const ProgramRun stopped =
        test::run_program("/bin/sh", {"-c", std::string(WIDEJAM_JAM_APP) + " sweep " + sweep() +
                                                " & until grep -qs . " +
                                                (out() / "seed=1" / "record.jsonl").string() +
                                                "; do sleep 0.05; done; kill -TERM $!; wait $!"});
    EXPECT_EQ(stopped.status, 3) << stopped.out << stopped.err;
    EXPECT_THAT(stopped.out, HasSubstr("SIGTERM: the runs save their states"));
    EXPECT_THAT(stopped.out, HasSubstr("0 running"));
    EXPECT_THAT(content_of(out() / "seed=1" / "output.log"), HasSubstr("stopped by SIGTERM"));
    EXPECT_TRUE(fs::exists(out() / "seed=1" / "packing.h5"));
}

TEST_F(JamAppSweep, TellsWhatFailedAndDoesTheRest) {
    write("run.seed = [1, 2]");
    fs::create_directories(out() / "seed=1");
    std::ofstream(out() / "seed=1" / "checkpoint.h5") << "no checkpoint";
    const ProgramRun done = run();
    EXPECT_EQ(done.status, 1) << done.out;
    EXPECT_THAT(done.out, HasSubstr("failed: seed=1: "));
    EXPECT_THAT(done.out, HasSubstr("1 converged, 0 running, 0 stopped, 1 failed"));
    EXPECT_TRUE(fs::exists(out() / "seed=2" / "converged"));
}

TEST_F(JamAppSweep, RefusesRunsOfAnotherScene) {
    write("run.seed = [1]");
    ASSERT_EQ(run().status, 0);
    write("run.seed = [1]", "[contact]\ndamping = 0.25\n");
    const ProgramRun refused = run();
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("contact.damping = 0.25 (was 0.5)"));
}

}  // namespace
}  // namespace jam
