// SPDX-License-Identifier: BSD-3-Clause
#include "packing/extended_xyz.h"

#include "support/example_packings.h"
#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace jam {
namespace {

using namespace jam::test;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string xyz_spheres =
    "2\n"
    "Step=40 Lattice=\"10 0 0 -2.5 8 0 1.5 0.5 6\" note=\"a b=c\" converged Origin=\"1 2 3\" "
    "Properties=radius:R:1:species:S:1:stress:R:2:pos:R:3:velo:R:3 Time=0.25 pbc=\"T T T\"\n"
    "0.5 A 9 9 2 3 4 0.5 0 0\n"
    "0.75 B 9 9 1 2 3 0 0 -1\n";

Packing read_xyz_text(const std::string& text) {
    const ScratchFolder folder;
    std::ofstream(folder / "some.xyz") << text;
    return read_extended_xyz(folder / "some.xyz");
}

TEST(ExtendedXyz, ReadsPropertiesInAnyOrder) {
    const Packing packing = read_xyz_text(xyz_spheres);
    Mat3 h;
    h << 10, -2.5, 1.5, 0, 8, 0.5, 0, 0, 6;
    EXPECT_EQ(packing.cell.matrix(), h);
    EXPECT_THAT(packing.ids, ElementsAre(1, 2));
    EXPECT_THAT(packing.diameters, ElementsAre(1.0, 1.5));
    EXPECT_THAT(packing.positions, ElementsAre(Vec3(1, 1, 1), Vec3(0, 0, 0)));
    EXPECT_THAT(packing.velocities, ElementsAre(Vec3(0.5, 0, 0), Vec3(0, 0, -1)));
    EXPECT_EQ(packing.step, 40);
    EXPECT_EQ(packing.time, 0.25);
}

TEST(ExtendedXyz, TheLastFrame) {
    const std::string later = replaced(xyz_spheres, "Step=40", "Step=50");
    EXPECT_EQ(read_xyz_text(xyz_spheres + later + "\n").step, 50);
}

TEST(ExtendedXyz, RoundTripKeepsEveryValue) {
    const ScratchFolder folder;
    const Packing saved = example_packing(2000);
    write_extended_xyz(saved, folder / "packing.xyz");
    const Packing read = read_extended_xyz(folder / "packing.xyz");
    EXPECT_EQ(read.cell.matrix(), saved.cell.matrix());
    EXPECT_EQ(read.positions, saved.positions);
    EXPECT_EQ(read.velocities, saved.velocities);
    EXPECT_EQ(read.diameters, saved.diameters);
    EXPECT_EQ(read.ids, saved.ids);
    EXPECT_EQ(read.step, saved.step);
    EXPECT_EQ(read.time, saved.time);
}

TEST(ExtendedXyz, SaysFileLineAndRemedy) {
    const auto refusal = [](std::string_view part, std::string_view by) {
        return refusal_of([&] { read_xyz_text(replaced(xyz_spheres, part, by)); });
    };
    EXPECT_THAT(refusal("0.75 B", "0.0 B"), HasSubstr("some.xyz:4: radius is 0.0"));
    EXPECT_THAT(refusal("Lattice", "Cell"), HasSubstr("Lattice="));
    EXPECT_THAT(refusal("0.5 6\"", "6\""), HasSubstr("nine finite numbers"));
    EXPECT_THAT(refusal("10 0 0 -2.5", "10 1 0 -2.5"), HasSubstr("some.xyz:2: cell: edges"));
    EXPECT_THAT(refusal("T T T", "T F T"), HasSubstr("not periodic"));
    EXPECT_THAT(refusal("Properties", "properties"), HasSubstr("Properties=..."));
    EXPECT_THAT(refusal("stress:R:2", "stress:R"), HasSubstr("name:type:count"));
    EXPECT_THAT(refusal("radius", "size"), HasSubstr("give diameter or radius"));
    EXPECT_THAT(refusal("2\nStep", "3\nStep"), HasSubstr("ends after 2 of 3"));
    EXPECT_THAT(refusal("2\nStep", "1\nStep"), HasSubstr("not a number of spheres"));
    EXPECT_THAT(refusal("B 9 9 1", "B 9 9 nan"), HasSubstr("x is 'nan'"));
    EXPECT_THAT(refusal_of([] { read_xyz_text(""); }), HasSubstr("the file is empty"));
}

}  // namespace
}  // namespace jam
