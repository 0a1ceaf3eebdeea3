// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/sweep_file.h"

#include "support/refusals.h"
#include "support/scratch_folder.h"
#include "sweep/run_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace jam {
namespace {

using namespace jam::test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string many = R"([grid]
sizes.size_ratio = [2, 10]
run.seed = [3, 1]

[sweep]
output = "runs/many"
threads = 4

[sizes]
kind = "power-law"
alpha = 0.55
count = 100
)";

class SweepFile : public testing::Test {
  protected:
    Sweep read(const std::string& text) const {
        std::ofstream(folder_ / "many.toml") << text;
        return read_sweep(folder_ / "many.toml");
    }
    std::string refusal(const std::string& text) const {
        return refusal_of([&] { read(text); });
    }
    std::filesystem::path file() const { return folder_ / "many.toml"; }

    ScratchFolder folder_;
};

std::vector<std::string> names(const Sweep& sweep) {
    std::vector<std::string> out;
    for (const SweepRun& run : sweep.runs) out.push_back(run.name);
    return out;
}

TEST_F(SweepFile, MakesARunOfEachCombinationInTheOrderOfTheFile) {
    const Sweep sweep = read(many);
    EXPECT_THAT(names(sweep), ElementsAre("size_ratio=2_seed=3", "size_ratio=2_seed=1",
                                          "size_ratio=10_seed=3", "size_ratio=10_seed=1"));
    EXPECT_EQ(sweep.threads, 4);
    const Scene& third = sweep.runs[2].scene;
    EXPECT_EQ(third.run.seed, 3u);
    EXPECT_EQ(std::get<PowerLaw>(third.sizes.distribution).size_ratio, 10.0);
    EXPECT_EQ(std::get<PowerLaw>(third.sizes.distribution).alpha, 0.55);
    EXPECT_EQ(third.run.output, "runs/many/size_ratio=10_seed=3");
}

TEST_F(SweepFile, TakesItsSceneFromAFileBesideIt) {
    std::ofstream(folder_ / "base.toml") << "[sizes]\nkind = \"monodisperse\"\ncount = 7\n";
    const Sweep sweep = read("scene = \"base.toml\"\n[grid]\n\"run.seed\" = [1, 2]\n");
    EXPECT_THAT(names(sweep), ElementsAre("seed=1", "seed=2"));
    EXPECT_EQ(sweep.output, "runs/many");
    EXPECT_EQ(particle_count(sweep.runs[1].scene.sizes), 7);
}

TEST_F(SweepFile, NamesRunsByWholeKeysWhereTheirEndsAreAlike) {
    const Sweep sweep = read(replaced(many, "run.seed = [3, 1]",
                                      "protocol.pressure = [1e-3, [1e-3,1e-3,2e-3,0,0,0]]\n"
                                      "stop.pressure = [0.01]"));
    EXPECT_EQ(sweep.runs[1].name,
              "size_ratio=2_protocol.pressure=1e-3_1e-3_2e-3_0_0_0_stop.pressure=0.01");
    EXPECT_EQ(sweep.runs[1].scene.protocol.pressure(2, 2), 2e-3);
}

TEST_F(SweepFile, AnswersMistakesOfTheGridWithTheirPlaceOnce) {
    const std::string said = refusal(replaced(many, "[2, 10]", "[2, 0.5, 10]"));
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    EXPECT_THAT(said, AllOf(HasSubstr("many.toml:2:24: sizes.size_ratio = 0.5: must be"),
                            HasSubstr("write for example")));
}

TEST_F(SweepFile, AnswersMistakesOfTheScene) {
    EXPECT_THAT(refusal(replaced(many, "alpha = 0.55", "alfa = 0.55")),
                AllOf(HasSubstr("many.toml:11:"), HasSubstr("did you mean sizes.alpha?")));
    EXPECT_THAT(refusal(replaced(many, "run.seed", "run.sede")), HasSubstr("many.toml:3:"));
}

TEST_F(SweepFile, AnswersMistakesOfTheSweep) {
    EXPECT_THAT(refusal(replaced(many, "[3, 1]", "3")),
                AllOf(HasSubstr("many.toml:3:"), HasSubstr("must be a list of values")));
    EXPECT_THAT(refusal(replaced(many, "[3, 1]", "[]")), HasSubstr("must be a list of values"));
    EXPECT_THAT(refusal(replaced(many, "[3, 1]", "[3, 3]")), HasSubstr("seed=3"));
    EXPECT_THAT(refusal(replaced(many, "threads = 4", "threads = -1")),
                HasSubstr("sweep.threads = -1: must be a whole number from 0"));
    EXPECT_THAT(refusal(replaced(many, "threads = 4", "thread = 4")),
                HasSubstr("sweep.thread: no such key"));
    EXPECT_THAT(refusal("[sizes]\nkind = \"monodisperse\"\ncount = 7\n"),
                HasSubstr("[grid]: missing"));
    EXPECT_THAT(refusal("[grid\n"), AllOf(HasSubstr("many.toml:1:"), HasSubstr("not TOML")));
    EXPECT_THAT(refusal("scene = \"none.toml\"\n[grid]\nrun.seed = [1]\n"), HasSubstr("none.toml"));
    EXPECT_THAT(refusal("scene = \"many.toml\"\n" + many), HasSubstr("not both"));
    EXPECT_THAT(refusal(replaced(many, "run.seed", "run.output")), HasSubstr("sweep.output"));
}

TEST_F(SweepFile, KnowsHowFarARunIs) {
    const Sweep sweep = read(replaced(many, "runs/many", (folder_ / "out").string()));
    const SweepRun& run = sweep.runs[0];
    EXPECT_EQ(state_of(run), RunState::left);
    prepare_folder(run);
    EXPECT_EQ(state_of(run), RunState::left);
    std::ofstream(run.scene.run.output / "checkpoint.h5") << "some";
    EXPECT_EQ(state_of(run), RunState::begun);
    mark_converged(run);
    EXPECT_EQ(state_of(run), RunState::converged);
    SweepRun stricter = run;
    stricter.scene.stop.cundall *= 0.1;
    EXPECT_EQ(state_of(stricter), RunState::begun);
    SweepRun other = run;
    other.scene.contact.damping = 0.25;
    EXPECT_THAT(refusal_of([&] { state_of(other); }),
                AllOf(HasSubstr("contact.damping = 0.25"), HasSubstr("sweep.output")));
}

}  // namespace
}  // namespace jam
