// SPDX-License-Identifier: BSD-3-Clause
// Scenes from text: every key's good and bad values, the rules between keys, and what the user
// hears.
#include "jamming/scene_file.h"

#include "core/check.h"
#include "jamming/scene_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace jam {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Texts = std::vector<std::string>;

const std::string power_law = "[sizes]\nkind = \"power-law\"\nsize_ratio = 5\nalpha = 0.55\n";

/// The message of the InputError that the scene throws; empty if it throws none.
std::string message_of(const std::string& text, const Texts& overrides = {}) {
    try {
        parse_scene(text, "dir/scene.toml", overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// Files that scenes in these tests may name.
struct SceneFileTest : testing::Test {
    void SetUp() override {
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "diameters.csv") << "1\n1.5\n2\n";
        std::ofstream(folder / "packing.h5") << "not read here\n";
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                   (std::string("widejam_scene_") +
                                    testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(SceneFileTest, AShortSceneTakesTheDefaults) {
    const Scene scene = parse_scene(power_law, "scene.toml");
    const auto& sizes = std::get<PowerLaw>(scene.sizes.distribution);
    EXPECT_EQ(sizes.size_ratio, 5.0);
    EXPECT_EQ(sizes.alpha, 0.55);
    EXPECT_FALSE(scene.sizes.count);
    EXPECT_EQ(scene.start.volume_fraction, 0.3);
    EXPECT_EQ(scene.protocol.pressure, Mat3(Mat3::Identity() * 1e-6));
    EXPECT_EQ(scene.contact.damping, 0.5);
    EXPECT_EQ(scene.stop.cundall, 1e-6);
}

// --- every key ----------------------------------------------------------------------------------

struct KeyCase {
    std::string rest;  ///< what else the scene needs, before the key
    Texts good;
    Texts bad;
};

const Texts no_positive_number = {"0", "-1", "nan", "inf", "-inf", "1e300", "\"1\"", "true", "[1]"};

/// Bad values of a number that must not fall below zero.
const Texts no_number_from_zero = {"-1e-9", "nan", "inf", "1e300", "\"1\"", "true", "1979-05-27"};

const Texts no_count = {"0",     "-3",    "2.5",  "nan", "inf",
                        "1e300", "\"7\"", "true", "[7]", "200000000"};
const Texts no_steps = {"0", "-3", "2.5", "nan", "1e17", "\"7\"", "true"};
const Texts no_word = {"\"Hooke\"", "\"\"", "1", "true", "[\"hooke\"]"};

std::string sizes(const std::string& lines) {
    return "[sizes]\n" + lines;
}

const std::map<std::string, KeyCase>& cases() {
    const std::string kind = "[sizes]\nkind = ";
    const std::string mono = kind + "\"monodisperse\"\ncount = 50\n";
    const std::string contact = mono + "[contact]\n";
    const std::string start = mono + "[start]\n";
    const std::string protocol = mono + "[protocol]\n";
    const std::string stop = mono + "[stop]\n";
    const std::string run = mono + "[run]\n";
    static const std::map<std::string, KeyCase> all = {
        {"sizes.kind", {sizes("count = 50\n"), {"\"monodisperse\""}, no_word}},
        {"sizes.alpha",
         {kind + "\"power-law\"\nsize_ratio = 4\n",
          {"0.55", "-0.5", "1", "4"},
          {"nan", "inf", "11", "-11", "\"0.5\"", "[0.5]", "false"}}},
        {"sizes.beta",
         {kind + "\"power-law\"\nsize_ratio = 4\n",
          {"3.45", "4", "3"},
          {"nan", "-inf", "15", "-7", "\"x\""}}},
        {"sizes.size_ratio",
         {kind + "\"power-law\"\nalpha = 1.5\ncount = 99\n",
          {"1", "5", "1e3"},
          {"0.99", "0", "-5", "nan", "inf", "1e6", "\"5\""}}},
        {"sizes.small_fraction",
         {kind + "\"binary\"\nsize_ratio = 4\nlarge_count = 5\n",
          {"0.25", "0.5"},
          {"-0.1", "1.1", "nan", "\"half\""}}},
        {"sizes.large_count",
         {kind + "\"binary\"\nsize_ratio = 4\nsmall_fraction = 0.3\n",
          {"1", "100", "1e2"},
          no_count}},
        {"sizes.eta",
         {kind + "\"grain-size-distribution\"\nsize_ratio = 4\n",
          {"0.6", "2"},
          {"0", "-1", "nan", "inf", "11", "\"x\""}}},
        {"sizes.sigma",
         {kind + "\"lognormal\"\nsize_ratio = 3\n",
          {"0.1", "0.8"},
          {"0", "-1", "nan", "inf", "6", "\"x\""}}},
        {"sizes.file",
         {kind + "\"table\"\n",
          {"\"diameters.csv\""},
          {"\"\"", "\"missing.csv\"", "\".\"", "5", "[1]"}}},
        {"sizes.weight",
         {kind + "\"table\"\nfile = \"diameters.csv\"\n",
          {"\"volume\"", "\"number\""},
          {"\"mass\"", "1"}}},
        {"sizes.count", {kind + "\"monodisperse\"\n", {"1", "5000", "1e4"}, no_count}},
        {"sizes.draw",
         {kind + "\"power-law\"\nalpha = 1\nsize_ratio = 2\n",
          {"\"stratified\"", "\"random\""},
          {"\"sobol\"", "1"}}},
        {"contact.law", {contact, {"\"hooke\"", "\"hertz\""}, no_word}},
        {"contact.stiffness", {contact, {"1", "2.5"}, no_positive_number}},
        {"contact.damping", {contact, {"0", "0.5", "50"}, no_number_from_zero}},
        {"contact.density", {contact, {"1", "2650.0"}, no_positive_number}},
        {"start.volume_fraction",
         {start, {"0.01", "0.3", "0.6"}, {"0", "-0.1", "0.61", "nan", "\"low\""}}},
        {"start.packing",
         {"[start]\n", {"\"packing.h5\""}, {"\"\"", "\"missing.h5\"", "1", "\".\""}}},
        {"protocol.kind", {protocol, {"\"quasistatic\"", "\"nph\""}, {"\"npt\"", "\"\"", "3"}}},
        {"protocol.accuracy",
         {protocol, {"\"fast\"", "\"standard\"", "\"paper\""}, {"\"exact\"", "1", "true"}}},
        {"protocol.pressure",
         {protocol,
          {"1e-6", "1e-9", "0.1", "1", "[1e-6, 2e-6, 3e-6, 0, 0, 0]",
           "[1e-6, 1e-6, 1e-6, 1e-7, -1e-7, 1e-8]", "[1, 1, 1, 0, 0, 0]"},
          {"0", "-1e-6", "nan", "inf", "1e13", "\"low\"", "[]", "[1e-6, 1e-6, 1e-6]",
           "[1e-6, 1e-6, 1e-6, 0, 0, nan]", "[1e-6, 1e-6, 1e-6, 2e-6, 0, 0]",
           "[1e-6, 1e-6, -1e-6, 0, 0, 0]", "[[1e-6]]"}}},
        {"protocol.free_cell", {protocol, {"\"all\"", "\"orthogonal\"", "\"isotropic\""}, no_word}},
        {"protocol.time_step",
         {protocol,
          {"0.02", "\"automatic\""},
          {"0", "-0.02", "nan", "inf", "11", "\"auto\"", "true"}}},
        {"protocol.masses",
         {protocol, {"\"true\"", "\"diameter\"", "\"equal\""}, {"true", "\"x\""}}},
        {"protocol.cell_inertia", {protocol, {"1", "0.1"}, no_positive_number}},
        {"protocol.cell_damping", {protocol, {"0", "2"}, no_number_from_zero}},
        {"protocol.compaction_pressure",
         {protocol, {"1e-3", "\"automatic\""}, {"0", "-1e-3", "nan", "\"high\""}}},
        {"protocol.compaction_steps", {protocol, {"0", "6000"}, {"-1", "0.5", "\"some\""}}},
        {"protocol.descent_rate", {protocol, {"1e-5", "1"}, no_positive_number}},
        {"protocol.descent_cundall", {protocol, {"1e-5", "1"}, no_positive_number}},
        {"stop.pressure", {stop, {"1e-4", "1"}, no_positive_number}},
        {"stop.cundall", {stop, {"1e-6", "1e-12"}, no_positive_number}},
        {"stop.stability", {stop, {"true", "false"}, {"1", "\"yes\"", "0.5"}}},
        {"stop.kinetic_energy", {stop, {"1e-13", "1e-20"}, no_positive_number}},
        {"stop.volume_fraction_change", {stop, {"1e-8"}, no_positive_number}},
        {"stop.coordination_change", {stop, {"1e-3"}, no_positive_number}},
        {"stop.window", {stop, {"1", "1e6"}, no_steps}},
        {"stop.max_steps", {stop, {"0", "1", "2000000000000"}, {"-1", "2.5", "\"7\"", "nan"}}},
        {"stop.max_time", {stop, {"0", "3600", "0.5"}, no_number_from_zero}},
        {"run.seed", {run, {"0", "9223372036854775807"}, {"-1", "0.5", "\"a\""}}},
        {"run.threads", {run, {"0", "2"}, {"-1", "0.5", "\"all\"", "1e9"}}},
        {"run.record_interval", {run, {"1", "1e5"}, no_steps}},
        {"run.checkpoint_interval", {run, {"1", "1e5"}, no_steps}},
        {"run.output", {run, {"\"runs/x\""}, {"\"\"", "5"}}},
        {"run.neighbor_method",
         {run, {"\"default\"", "\"multi-old\"", "\"multi\""}, {"\"single\"", "1"}}},
        {"run.collection_ratio", {run, {"4", "1.5", "\"automatic\""}, {"1", "0", "\"few\""}}},
    };
    return all;
}

std::string last_part(const std::string& name) {
    return name.substr(name.find('.') + 1);
}

TEST_F(SceneFileTest, TheCasesCoverEveryKey) {
    std::set<std::string> tested, known;
    for (const auto& [name, one] : cases()) tested.insert(name);
    for (const SceneKey& key : scene_keys()) known.insert(key.name);
    EXPECT_EQ(tested, known);
}

TEST_F(SceneFileTest, AccuracyGivesDefaultsThatOtherKeysOverruleInAnyOrder) {
    const std::string sizes = "[sizes]\nkind = \"monodisperse\"\ncount = 10\n";
    const auto scene = [&](const std::string& lines) {
        return parse_scene(sizes + "[protocol]\n" + lines, "scene.toml");
    };
    const Scene standard = scene("");
    const Scene fast = scene("descent_cundall = 2e-4\naccuracy = \"fast\"\n");
    EXPECT_GT(fast.protocol.descent.rate, standard.protocol.descent.rate);
    EXPECT_EQ(fast.protocol.descent.cundall, 2e-4);
    EXPECT_GT(fast.stop.cundall, standard.stop.cundall);
    EXPECT_FALSE(fast.stop.stability);
    EXPECT_TRUE(standard.stop.stability);
    EXPECT_LT(scene("accuracy = \"paper\"\n").protocol.descent.rate,
              standard.protocol.descent.rate);
    const Scene again = parse_scene(scene_text(fast), "scene.toml");
    EXPECT_EQ(scene_text(again), scene_text(fast));
}

TEST_F(SceneFileTest, GoodValuesAreTaken) {
    for (const auto& [name, one] : cases())
        for (const std::string& value : one.good) {
            const std::string text = one.rest + last_part(name) + " = " + value + "\n";
            EXPECT_NO_THROW(parse_scene(text, folder / "scene.toml")) << text;
        }
}

TEST_F(SceneFileTest, BadValuesAreAnsweredWithPlaceKeyValueRuleAndRemedy) {
    for (const auto& [name, one] : cases())
        for (const std::string& value : one.bad) {
            const std::string text = one.rest + last_part(name) + " = " + value + "\n";
            const std::string file = (folder / "scene.toml").string();
            const auto lines = std::ranges::count(text, '\n');
            const std::string where =
                fmt::format("{}:{}:{}: {} = ", file, lines, last_part(name).size() + 4, name);
            try {
                parse_scene(text, file);
                ADD_FAILURE() << "taken: " << text;
            } catch (const InputError& error) {
                EXPECT_THAT(error.what(), HasSubstr(where)) << text;
                EXPECT_THAT(error.what(), HasSubstr(": must be ")) << text;
                EXPECT_THAT(error.what(), HasSubstr("; ")) << text;
            }
        }
}

TEST_F(SceneFileTest, BadValuesNameTheRuleOfTheKey) {
    for (const SceneKey& key : scene_keys()) {
        const KeyCase& one = cases().at(key.name);
        const std::string text = one.rest + last_part(key.name) + " = [true]\n";
        EXPECT_THAT(message_of(text), HasSubstr("must be " + key.field.rule)) << key.name;
        EXPECT_THAT(message_of(text),
                    HasSubstr("write for example " + key.name + " = " + toml_text(key.example)));
    }
}

TEST_F(SceneFileTest, OverridesMeetTheSameRules) {
    for (const auto& [name, one] : cases())
        for (const std::string& value : one.bad) {
            const std::string message = message_of(one.rest, {name + "=" + value});
            EXPECT_THAT(message, HasSubstr("--set: " + name + " = ")) << value;
        }
}

// --- values -------------------------------------------------------------------------------------

TEST_F(SceneFileTest, BetaIsFourMinusAlpha) {
    const Scene scene = parse_scene(sizes("kind = \"power-law\"\nsize_ratio = 2\nbeta = 3\n"), "s");
    EXPECT_EQ(std::get<PowerLaw>(scene.sizes.distribution).alpha, 1.0);
}

TEST_F(SceneFileTest, SixPressuresStandInVoigtOrder) {
    const Scene scene = parse_scene(
        power_law, "s", Texts{"protocol.pressure=[4,5,6,0.1,0.2,0.3]", "contact.stiffness=100"});
    Mat3 expected;
    expected << 4, 0.3, 0.2, 0.3, 5, 0.1, 0.2, 0.1, 6;
    EXPECT_EQ(scene.protocol.pressure, expected);
}

TEST_F(SceneFileTest, TablesAreReadFromBesideTheScene) {
    const Scene scene =
        parse_scene(sizes("kind = \"table\"\nfile = \"diameters.csv\"\n"), folder / "scene.toml");
    EXPECT_EQ(particle_count(scene.sizes), 3);
    EXPECT_EQ(scene.sizes.file, folder / "diameters.csv");
}

TEST_F(SceneFileTest, ADamagedTableIsAnsweredWithItsLine) {
    std::ofstream(folder / "diameters.csv") << "1\n-2\n";
    try {
        parse_scene(sizes("kind = \"table\"\nfile = \"diameters.csv\"\n"), folder / "scene.toml");
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("scene.toml:1:"));
        EXPECT_THAT(error.what(), HasSubstr("diameters.csv"));
    }
}

TEST_F(SceneFileTest, TheDiametersComeFromTheSettings) {
    const Scene scene = parse_scene(power_law, "s", Texts{"sizes.count=500", "sizes.draw=random"});
    EXPECT_EQ(draw_diameters(scene),
              draw_diameters(PowerLaw{5.0, 0.55}, 500, DrawMethod::random, scene.run.seed));
}

// --- overrides ----------------------------------------------------------------------------------

TEST_F(SceneFileTest, OverridesReplaceTheFile) {
    const Scene scene = parse_scene(power_law, "s", Texts{"sizes.alpha=1", "run.seed = 7"});
    EXPECT_EQ(std::get<PowerLaw>(scene.sizes.distribution).alpha, 1.0);
    EXPECT_EQ(scene.run.seed, 7u);
}

TEST_F(SceneFileTest, WordsInOverridesNeedNoQuotes) {
    EXPECT_EQ(parse_scene(power_law, "s", Texts{"contact.law=hertz"}).contact.law,
              ContactLaw::hertz);
    EXPECT_EQ(parse_scene(power_law, "s", Texts{"contact.law=\"hertz\""}).contact.law,
              ContactLaw::hertz);
    EXPECT_EQ(parse_scene(power_law, "s", Texts{"run.output=runs/a b"}).run.output, "runs/a b");
}

TEST_F(SceneFileTest, AnOverrideMendsWhatTheFileHasWrong) {
    EXPECT_EQ(message_of(power_law + "[run]\nseed = -1\n", {"run.seed=1"}), "");
}

TEST_F(SceneFileTest, OverridesThatSetNothingAreRefused) {
    for (const char* text : {"", "=", "sizes.alpha", "sizes.alpha=", "=3", " = "})
        EXPECT_THAT(message_of(power_law, {text}), HasSubstr("must be table.key=value")) << text;
}

TEST_F(SceneFileTest, AnOverrideCannotCarryASecondKey) {
    EXPECT_THAT(message_of(power_law, {"run.seed=1\nother = 2"}), StartsWith("--set: run.seed = "));
}

// --- unknown keys -------------------------------------------------------------------------------

TEST_F(SceneFileTest, UnknownKeysNameTheNearestKnownOne) {
    EXPECT_THAT(message_of(power_law + "[run]\nsede = 1\n"),
                "dir/scene.toml:6:8: run.sede = 1: no such key; did you mean run.seed?");
    EXPECT_THAT(message_of(power_law + "[contact]\nstifness = 1\n"),
                HasSubstr("did you mean contact.stiffness?"));
    EXPECT_THAT(message_of("[size]\nkind = \"binary\"\n" + power_law),
                HasSubstr("size.kind = \"binary\": no such key; did you mean sizes.kind?"));
    EXPECT_THAT(message_of("seed = 3\n" + power_law), HasSubstr("did you mean run.seed?"));
    EXPECT_THAT(message_of(power_law, {"protocol.presure=1e-3"}),
                HasSubstr("--set: protocol.presure = 1e-3: no such key; did you mean "
                          "protocol.pressure?"));
}

TEST_F(SceneFileTest, KeysThatLookLikeNothingAreRefusedToo) {
    EXPECT_THAT(message_of(power_law + "[run]\nbanana = 1\n"), HasSubstr("jam_app keys"));
    EXPECT_THAT(message_of(power_law + "[bananas]\n"), HasSubstr("bananas"));
    EXPECT_THAT(message_of(power_law + "[run.seed]\n"), HasSubstr("run.seed"));
    EXPECT_THAT(message_of(power_law + "[run.seed]\ndeep = 1\n"), HasSubstr("run.seed"));
    EXPECT_THAT(message_of(power_law + "[[run]]\nseed = 1\n"), HasSubstr("write [run]"));
    EXPECT_THAT(message_of("run = 5\n" + power_law), HasSubstr("write [run]"));
}

// --- rules between keys -------------------------------------------------------------------------

TEST_F(SceneFileTest, AlphaAndBetaExcludeEachOther) {
    const std::string message = message_of(power_law + "beta = 3.2\n");
    EXPECT_THAT(message, StartsWith("dir/scene.toml:5:8: sizes.beta = 3.2: "));
    EXPECT_THAT(message, HasSubstr("sizes.alpha = 0.55"));
}

TEST_F(SceneFileTest, EveryKindSaysWhatItMisses) {
    for (const SizesKind& kind : sizes_kinds()) {
        const std::string message = message_of(sizes("kind = \"" + kind.name + "\"\n"));
        for (const std::string& name : kind.required)
            EXPECT_THAT(message, HasSubstr("dir/scene.toml:1:1: " + name + ": missing"));
    }
    EXPECT_THAT(message_of(""), StartsWith("dir/scene.toml: sizes.kind: missing"));
}

TEST_F(SceneFileTest, KeysOfAnotherKindAreRefused) {
    EXPECT_THAT(message_of(power_law + "large_count = 7\n"),
                "dir/scene.toml:5:15: sizes.large_count = 7: does not belong to sizes.kind = "
                "\"power-law\" but to binary; remove it");
}

TEST_F(SceneFileTest, MoreParticlesThanFitAreRefused) {
    EXPECT_THAT(message_of(sizes("kind = \"power-law\"\nsize_ratio = 1e4\nalpha = 0.2\n")),
                HasSubstr("sizes.count"));
}

TEST_F(SceneFileTest, APackingLeavesNoRoomForSizes) {
    const std::string from = "[start]\npacking = \"packing.h5\"\n";
    EXPECT_NO_THROW(parse_scene(from, folder / "scene.toml"));
    for (const std::string& other : {power_law, std::string("volume_fraction = 0.2\n")}) {
        try {
            parse_scene(from + other, folder / "scene.toml");
            ADD_FAILURE() << "taken: " << other;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("beside start.packing"));
        }
    }
}

TEST_F(SceneFileTest, PressureThatTheCellCannotFollowIsRefused) {
    const std::string sheared = "protocol.pressure=[1e-6,1e-6,1e-6,1e-7,0,0]";
    const std::string unequal = "protocol.pressure=[1e-6,2e-6,1e-6,0,0,0]";
    EXPECT_EQ(message_of(power_law, {sheared}), "");
    EXPECT_THAT(message_of(power_law, {sheared, "protocol.free_cell=orthogonal"}),
                HasSubstr("--set: protocol.pressure = [1e-6, 1e-6, 1e-6, 1e-7, 0, 0]: "));
    EXPECT_EQ(message_of(power_law, {unequal, "protocol.free_cell=orthogonal"}), "");
    EXPECT_THAT(message_of(power_law, {unequal, "protocol.free_cell=isotropic"}),
                HasSubstr("orthogonal"));
}

TEST_F(SceneFileTest, PressureAboveTheStiffnessIsRefused) {
    EXPECT_THAT(message_of(power_law, {"protocol.pressure=2"}), HasSubstr("contact.stiffness = 1"));
    EXPECT_EQ(message_of(power_law, {"protocol.pressure=2", "contact.stiffness=100"}), "");
}

// --- messages -----------------------------------------------------------------------------------

TEST_F(SceneFileTest, AllMistakesAreToldAtOnceInTheOrderOfTheFile) {
    const std::string message =
        message_of("[run]\nseed = -1\nthreads = \"x\"\n[contact]\nfoo = 1\n" + power_law);
    EXPECT_THAT(message, testing::MatchesRegex("dir/scene.toml:2:8: run.seed[^\n]*\n"
                                               "dir/scene.toml:3:11: run.threads[^\n]*\n"
                                               "dir/scene.toml:5:7: contact.foo[^\n]*"));
}

TEST_F(SceneFileTest, WhatIsNotTomlIsAnsweredWithItsPlace) {
    EXPECT_THAT(message_of("[sizes\n"), StartsWith("dir/scene.toml:1:7: this is not TOML: "));
    EXPECT_THAT(message_of(power_law + "alpha = 1\n"), StartsWith("dir/scene.toml:5:"));
    EXPECT_THAT(message_of(std::string("\0\1\xff", 3)), HasSubstr("this is not TOML"));
}

TEST_F(SceneFileTest, LongValuesAreShortenedInMessages) {
    const std::string message = message_of(power_law + "draw = \"" + std::string(5000, 'x') + "\"");
    EXPECT_LT(message.size(), 400u);
}

TEST_F(SceneFileTest, FilesThatCannotBeReadAreNamed) {
    for (const std::filesystem::path& path : {folder / "missing.toml", folder}) {
        try {
            read_scene(path);
            ADD_FAILURE() << "read: " << path;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), StartsWith(path.string() + ": must be a scene file"));
        }
    }
}

}  // namespace
}  // namespace jam
