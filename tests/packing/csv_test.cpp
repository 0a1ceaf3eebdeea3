// SPDX-License-Identifier: BSD-3-Clause
#include "packing/csv.h"

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

const std::string csv_spheres =
    "# made by hand\r\n"
    "# cell: 10 0 0 -2.5 8 0 1.5 0.5 6\r\n"
    "x, y, z, color, diameter, id\r\n"
    "1, 2, 3, red, 1.5, 8\r\n"
    "-1, 2, 3, blue, +2, 4\r\n\r\n";

Packing read_csv_text(const std::string& text) {
    const ScratchFolder folder;
    std::ofstream(folder / "some.csv") << text;
    return read_csv(folder / "some.csv");
}

TEST(Csv, ReadsColumnsInAnyOrder) {
    const Packing packing = read_csv_text(csv_spheres);
    Mat3 h;
    h << 10, -2.5, 1.5, 0, 8, 0.5, 0, 0, 6;
    EXPECT_EQ(packing.cell.matrix(), h);
    EXPECT_THAT(packing.ids, ElementsAre(8, 4));
    EXPECT_THAT(packing.diameters, ElementsAre(1.5, 2.0));
    EXPECT_THAT(packing.positions, ElementsAre(Vec3(1, 2, 3), Vec3(-1, 2, 3)));
    EXPECT_TRUE(packing.velocities.empty());
}

TEST(Csv, RoundTripKeepsEveryValue) {
    const ScratchFolder folder;
    const Packing saved = example_packing(2000);
    write_csv(saved, folder / "packing.csv");
    const Packing read = read_csv(folder / "packing.csv");
    EXPECT_EQ(read.cell.matrix(), saved.cell.matrix());
    EXPECT_EQ(read.positions, saved.positions);
    EXPECT_EQ(read.velocities, saved.velocities);
    EXPECT_EQ(read.diameters, saved.diameters);
    EXPECT_EQ(read.ids, saved.ids);
}

TEST(Csv, SaysFileLineAndRemedy) {
    const auto refusal = [](std::string_view part, std::string_view by) {
        return refusal_of([&] { read_csv_text(replaced(csv_spheres, part, by)); });
    };
    EXPECT_THAT(refusal("cell:", "box:"), HasSubstr("# cell: ax ay az"));
    EXPECT_THAT(refusal("0.5 6", "6"), HasSubstr("some.csv:2:"));
    EXPECT_THAT(refusal("0.5 6", "0.5 -6"), HasSubstr("some.csv:2: cell: lx"));
    EXPECT_THAT(refusal("0.5 6", "0.5 six"), HasSubstr("not a finite number"));
    EXPECT_THAT(refusal("1.5, 8", "1.5"), HasSubstr("some.csv:4: 5 of 6 columns"));
    EXPECT_THAT(refusal("1.5, 8", "1.5, 8, 9"), HasSubstr("more than 6 columns"));
    EXPECT_THAT(refusal("1.5, 8", "1.5, 4"), HasSubstr("lines 4 and 5 both have the id 4"));
    EXPECT_THAT(refusal("1, 2, 3, red", "1, , 3, red"), HasSubstr("y is '"));
    EXPECT_THAT(refusal("-1, 2", "\r\n-1, 2"), HasSubstr("follows an empty line"));
    EXPECT_THAT(refusal_of([] { read_csv_text("# cell: 1 0 0 0 1 0 0 0 1\nx,y,z,diameter\n"); }),
                HasSubstr("no spheres"));
}

}  // namespace
}  // namespace jam
