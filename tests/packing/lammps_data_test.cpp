// SPDX-License-Identifier: BSD-3-Clause
#include "packing/lammps_data.h"

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
using testing::ElementsAre;
using testing::HasSubstr;

const std::string data_spheres = R"(LAMMPS data file via write_data

3 atoms  # in all
2 atom types

-1 9 xlo xhi
2 10 ylo yhi
0.5 6.5 zlo zhi
-2.5 1.5 0.5 xy xz yz

Masses

1 1
2 8

Atoms # sphere

7 1 1.5 2.5 0 3 1.5 0 -1 2
2 2 1 2.5 8 3 0.5 0 0 0
5 1 4 2.5 -1 2 0.5 1 0 0

Velocities

2 0.5 0 0 0 0 1
5 0 0.25 0 0 0 2
7 0 0 -1 0 0 3
)";

Packing read_data_text(const std::string& text) {
    const ScratchFolder folder;
    std::ofstream(folder / "some.data") << text;
    return read_lammps_data(folder / "some.data");
}

TEST(LammpsData, ReadsWhatWriteDataGives) {
    const Packing packing = read_data_text(data_spheres);
    Mat3 h;
    h << 10, -2.5, 1.5, 0, 8, 0.5, 0, 0, 6;
    EXPECT_EQ(packing.cell.matrix(), h);
    EXPECT_THAT(packing.ids, ElementsAre(7, 2, 5));
    EXPECT_THAT(packing.diameters, ElementsAre(1.5, 1.0, 4.0));
    EXPECT_THAT(packing.positions, ElementsAre(Vec3(1, 1, 1), Vec3(9, 1, 0), Vec3(0, 0, 0)));
    EXPECT_THAT(packing.velocities, ElementsAre(Vec3(0, 0, -1), Vec3(0.5, 0, 0), Vec3(0, 0.25, 0)));
    EXPECT_EQ(packing.material.density, 2.5);
}

TEST(LammpsData, ReadsWithoutImagesTiltOrVelocities) {
    std::string text = data_spheres.substr(0, data_spheres.find("\nVelocities"));
    text = replaced(text, "-2.5 1.5 0.5 xy xz yz\n", "");
    for (const char* images : {" 0 -1 2\n", " 0 0 0\n", " 1 0 0\n"})
        text = replaced(text, images, "\n");
    const Packing packing = read_data_text(replaced(text, " # sphere", ""));
    EXPECT_TRUE(packing.cell.is_orthogonal());
    EXPECT_TRUE(packing.velocities.empty());
    EXPECT_EQ(packing.positions[1], Vec3(9, 1, 0));
}

TEST(LammpsData, RoundTripKeepsEveryValue) {
    const ScratchFolder folder;
    const Packing saved = example_packing(2000);
    write_lammps_data(saved, folder / "packing.data");
    const Packing read = read_lammps_data(folder / "packing.data");
    EXPECT_EQ(read.cell.matrix(), saved.cell.matrix());
    EXPECT_EQ(read.positions, saved.positions);
    EXPECT_EQ(read.velocities, saved.velocities);
    EXPECT_EQ(read.diameters, saved.diameters);
    EXPECT_EQ(read.ids, saved.ids);
    EXPECT_EQ(read.material.density, saved.material.density);
}

TEST(LammpsData, WritesTheCellReducedAsTheSameLattice) {
    const ScratchFolder folder;
    Packing packing = example_packing(4);
    Mat3 h;
    h << 8, 15, -6, 0, 4, 3, 0, 0, 5;
    packing.cell = PeriodicCell(h);
    write_lammps_data(packing, folder / "packing.data");
    const PeriodicCell read = read_lammps_data(folder / "packing.data").cell;
    EXPECT_TRUE(read.is_reduced());
    const Mat3 change = read.inverse() * h;
    EXPECT_TRUE(change.isApprox(change.array().round().matrix(), 1e-14));
    EXPECT_NEAR(read.volume(), packing.cell.volume(), 1e-12);
}

TEST(LammpsData, SaysFileLineAndRemedy) {
    const auto refusal = [](std::string_view part, std::string_view by) {
        return refusal_of([&] { read_data_text(replaced(data_spheres, part, by)); });
    };
    EXPECT_THAT(refusal("1.5 2.5 0 3", "-1.5 2.5 0 3"),
                AllOf(HasSubstr("some.data:18:"), HasSubstr("diameter is -1.5")));
    EXPECT_THAT(refusal("1.5 2.5 0 3", "1.5 2.25 0 3"), HasSubstr("one density"));
    EXPECT_THAT(refusal("3 atoms", "4 atoms"), HasSubstr("ends after 3 of 4"));
    EXPECT_THAT(refusal("3 atoms", "2 atoms"), HasSubstr("more lines than"));
    EXPECT_THAT(refusal("3 atoms", "0 atoms"), HasSubstr("some.data:3:"));
    EXPECT_THAT(refusal("# sphere", "# atomic"), HasSubstr("atom style is 'atomic'"));
    EXPECT_THAT(refusal("2 10 ylo yhi", ""), HasSubstr("ylo yhi"));
    EXPECT_THAT(refusal("\n2 2 1", "\n7 2 1"), HasSubstr("have the id 7"));
    EXPECT_THAT(refusal("\n2 0.5", "\n3 0.5"), HasSubstr("id '3'"));
    EXPECT_THAT(refusal("\n2 0.5", "\n5 0.5"), HasSubstr("id '5'"));
    EXPECT_THAT(refusal("0.25 0 0 0 2", "0.25"), HasSubstr("give all four"));
    EXPECT_THAT(refusal("0.25", "inf"), HasSubstr("finite"));
    EXPECT_THAT(refusal("Atoms #", "Bodies #"), HasSubstr("Atoms must come before"));
    EXPECT_THAT(refusal_of([&] { read_data_text("nothing\n"); }), HasSubstr("no section Atoms"));
}

}  // namespace
}  // namespace jam
