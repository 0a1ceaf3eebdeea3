// SPDX-License-Identifier: BSD-3-Clause
// analyze_app stats as a user runs it, held against what was computed elsewhere.
#include "support/data_folders.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace jam {
namespace {

using namespace test;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

ProgramRun stats(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "stats");
    return run_program(WIDEJAM_ANALYZE_APP, arguments);
}

json stats_json(const std::string& path, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {path, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = stats(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    return json::parse(run.out);
}

void expect_close(const json& value, const json& expected, const std::string& what) {
    EXPECT_NEAR(value.get<double>(), expected.get<double>(),
                1e-9 * std::abs(expected.get<double>()))
        << what;
}

class AnalyzeStats : public testing::TestWithParam<std::string> {};

TEST_P(AnalyzeStats, GivesWhatWasComputedElsewhere) {
    const json expected =
        json::parse(std::ifstream(packing_folder + "expected.json")).at(GetParam());
    const json found = stats_json(packing_folder + GetParam());
    EXPECT_EQ(found["particle_count"], expected["N"]);
    EXPECT_EQ(found["contact_count"], expected["Nc"]);
    EXPECT_EQ(found["rattler_count"], expected["Nr"]);
    expect_close(found["volume_fraction"], expected["phi"], "phi");
    expect_close(found["volume_fraction_nr"], expected["phi_nr"], "phi_nr");
    expect_close(found["coordination"], expected["Z"], "Z");
    expect_close(found["coordination_nr"], expected["Znr"], "Z_nr");
    expect_close(found["rattler_fraction"], expected["fr"], "f_r");
    expect_close(found["cundall"], expected["C"], "C");
    expect_close(found["cundall_nr"], expected["C_nr"], "C_nr");
    expect_close(found["largest_overlap"], expected["max_ov"], "largest overlap");
    expect_close(found["kinetic_energy_per_particle"], expected["KE"], "kinetic energy");
    const json& p = found["pressure"];
    const double scale = expected["Pxx"];
    for (const auto& [name, a, b] :
         {std::tuple("Pxx", 0, 0), std::tuple("Pyy", 1, 1), std::tuple("Pzz", 2, 2),
          std::tuple("Pxy", 0, 1), std::tuple("Pxz", 0, 2), std::tuple("Pyz", 1, 2)}) {
        EXPECT_NEAR(p[a][b].get<double>(), expected[name].get<double>(), 1e-9 * scale) << name;
        EXPECT_NEAR(p[b][a].get<double>(), expected[name].get<double>(), 1e-9 * scale) << name;
    }
    const json& cell = found["cell"];  // tilts as parts of the edge they lie along
    expect_close(cell[1][0].get<double>() / cell[0][0].get<double>(), expected["tilt"][0], "xy");
    expect_close(cell[2][0].get<double>() / cell[0][0].get<double>(), expected["tilt"][1], "xz");
    expect_close(cell[2][1].get<double>() / cell[1][1].get<double>(), expected["tilt"][2], "yz");
    EXPECT_EQ(found["contact_count_nr"].get<int>() -
                  3 * (found["particle_count"].get<int>() - found["rattler_count"].get<int>()),
              expected["iso_excess"]);
    EXPECT_EQ(found["cell"][0][1], 0.0);
}

INSTANTIATE_TEST_SUITE_P(Packings, AnalyzeStats,
                         testing::Values("lammps_lambda1_p1e-3.dump",
                                         "lammps_lambda5_alpha0.6_p5e-3.dump"),
                         [](const auto& packing) {
                             return "number" + std::to_string(packing.index);
                         });

TEST(AnalyzeAppStats, KeepsItsKeys) {
    const json found = stats_json(packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump");
    for (const char* key : {"particle_count", "size_ratio", "volume_fraction", "volume_fraction_nr",
                            "coordination", "coordination_nr", "rattler_fraction", "contact_count",
                            "cundall", "pressure", "cell", "kinetic_energy_per_particle"})
        EXPECT_TRUE(found.contains(key)) << key;
}

TEST(AnalyzeAppStats, TakesTheRattlerThreshold) {
    const std::string path = packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump";
    const json at_three = stats_json(path);
    const json at_four = stats_json(path, {"--rattler-threshold", "4"});
    EXPECT_EQ(at_three["rattler_threshold"], 3);
    EXPECT_EQ(at_four["rattler_threshold"], 4);
    EXPECT_GT(at_four["rattler_count"], at_three["rattler_count"]);
    EXPECT_EQ(at_four["contact_count"], at_three["contact_count"]);
}

TEST(AnalyzeAppStats, TheSameTextForAnyThreadCount) {
    const std::string path = packing_folder + "lammps_lambda1_p1e-3.dump";
    const std::string reference = stats({path, "--json", "--threads", "1"}).out;
    EXPECT_FALSE(reference.empty());
    for (const char* threads : {"2", "5"})
        EXPECT_EQ(stats({path, "--json", "--threads", threads}).out, reference);
}

TEST(AnalyzeAppStats, TellsPeopleTheSame) {
    const ProgramRun run = stats({packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, HasSubstr("3,557"));
    EXPECT_THAT(run.out, HasSubstr("0.71880"));
    EXPECT_THAT(run.out, HasSubstr("11,557"));
    EXPECT_THAT(run.out, HasSubstr("6.9669 in the backbone"));
    EXPECT_THAT(run.out, HasSubstr("7.42 %"));
}

TEST(AnalyzeAppStats, SaysNullWhereNothingIsDefined) {
    const ScratchFolder scratch;
    std::ofstream(scratch / "loose.dump")
        << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n"
           "0 10\n0 10\n0 10\nITEM: ATOMS id type diameter x y z\n1 1 1 1 1 1\n2 1 1 5 5 5\n";
    const json found = stats_json(scratch / "loose.dump");
    EXPECT_TRUE(found["cundall"].is_null());
    EXPECT_EQ(found["contact_count"], 0);
    EXPECT_EQ(found["rattler_fraction"], 1.0);
    EXPECT_EQ(stats({scratch / "loose.dump"}).status, 0);
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& named) {
    const ProgramRun run = stats(arguments);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_THAT(run.err, HasSubstr(named));
}

TEST(AnalyzeAppStats, RefusesWhatItCannotUse) {
    const ScratchFolder scratch;
    expect_refused({scratch / "absent.h5"}, "absent.h5");
    expect_refused({scratch / "absent.dump"}, "absent.dump");
    expect_refused({scratch.path()}, scratch.path());
    std::ofstream(scratch / "noise.h5") << "this is no HDF5 file";
    expect_refused({scratch / "noise.h5"}, "noise.h5");
    std::ofstream(scratch / "noise.dump") << "this is no dump";
    expect_refused({scratch / "noise.dump"}, "noise.dump");
    std::ofstream(scratch / "empty.dump");
    expect_refused({scratch / "empty.dump"}, "empty.dump");
    std::ofstream(scratch / "short.dump")
        << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n"
           "0 10\n0 10\n0 10\nITEM: ATOMS id type diameter x y z\n1 1 1 1 1 1\n";
    expect_refused({scratch / "short.dump"}, "short.dump");
}

TEST(AnalyzeAppStats, RefusesBadArguments) {
    const std::string path = packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump";
    expect_refused({}, "packing");
    expect_refused({path, "--rattler-threshold", "0"}, "rattler threshold");
    expect_refused({path, "--rattler-threshold", "many"}, "--rattler-threshold");
    expect_refused({path, "--no-such-option"}, "--no-such-option");
    const ProgramRun none = run_program(WIDEJAM_ANALYZE_APP, {});
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(run_program(WIDEJAM_ANALYZE_APP, {"--help"}).out, HasSubstr("stats"));
}

}  // namespace
}  // namespace jam
