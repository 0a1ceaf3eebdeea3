// SPDX-License-Identifier: BSD-3-Clause
#include "packing/lammps_dump.h"

#include "core/check.h"
#include "support/data_folders.h"
#include "support/example_packings.h"
#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace jam {
namespace {

using namespace jam::test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string dump_spheres = R"(ITEM: TIMESTEP
700
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp pp pp
-1 9
2 10
0.5 6.5
ITEM: ATOMS vx id z y x radius vy type vz
0.5 12 3 4 2 0.75 0.25 3 -1
0 -4 6 3 -1.5 0.5 0 1 0
)";

Packing read_dump_text(const std::string& text, Count frame = last_frame) {
    const ScratchFolder folder;
    std::ofstream(folder / "some.dump") << text;
    return read_lammps_dump(folder / "some.dump", frame);
}

std::string refusal_of_dump(const std::string& text, Count frame = last_frame) {
    return refusal_of([&] { read_dump_text(text, frame); });
}

TEST(LammpsDump, ReadsColumnsInAnyOrderAndTakesOffTheOrigin) {
    const Packing packing = read_dump_text(dump_spheres);
    EXPECT_EQ(packing.step, 700);
    EXPECT_EQ(packing.cell.matrix(), Mat3(Vec3(10, 8, 6).asDiagonal()));
    EXPECT_THAT(packing.ids, ElementsAre(12, -4));
    EXPECT_THAT(packing.diameters, ElementsAre(1.5, 1.0));
    EXPECT_THAT(packing.positions, ElementsAre(Vec3(3, 2, 2.5), Vec3(-0.5, 1, 5.5)));
    EXPECT_THAT(packing.velocities, ElementsAre(Vec3(0.5, 0.25, -1), Vec3(0, 0, 0)));
}

TEST(LammpsDump, ReadsScaledAndUnwrappedPositions) {
    const std::string rows = "ITEM: ATOMS diameter xs ys zs\n1 0.25 0.5 0.75\n1 1.25 0 -0.5\n";
    const std::string header = dump_spheres.substr(0, dump_spheres.find("ITEM: ATOMS"));
    const Packing scaled = read_dump_text(header + rows);
    EXPECT_THAT(scaled.positions, ElementsAre(Vec3(2.5, 4, 4.5), Vec3(12.5, 0, -3)));
    EXPECT_THAT(scaled.ids, ElementsAre(1, 2));
    EXPECT_TRUE(scaled.velocities.empty());
    const Packing unwrapped =
        read_dump_text(header + "ITEM: ATOMS diameter xu yu zu\n1 -1 2 0.5\n1 29 2 0.5\n");
    EXPECT_THAT(unwrapped.positions, ElementsAre(Vec3(0, 0, 0), Vec3(30, 0, 0)));
}

/// The bounds of the box around the cell, from its eight corners: no formula of LAMMPS in it.
std::string header_of(const Mat3& h, const Vec3& origin) {
    Vec3 low = origin, high = origin;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at = origin + h * Vec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
    }
    return fmt::format(
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
        "{:.17g} {:.17g} {:.17g}\n{:.17g} {:.17g} {:.17g}\n{:.17g} {:.17g} {:.17g}\n",
        low[0], high[0], h(0, 1), low[1], high[1], h(0, 2), low[2], high[2], h(1, 2));
}

TEST(LammpsDump, FindsTheCellInsideTheBoxAroundIt) {
    const Vec3 origin(-3.25, 0.5, 7.0);
    for (const double xy : {-1.5, 0.0, 2.25})
        for (const double xz : {-2.5, 0.0, 1.75})
            for (const double yz : {-1.25, 0.0, 0.5}) {
                Mat3 h;
                h << 8.0, xy, xz, 0.0, 4.0, yz, 0.0, 0.0, 5.0;
                const Packing packing = read_dump_text(
                    header_of(h, origin) + "ITEM: ATOMS id diameter x y z\n1 1 -3.25 0.5 8\n");
                EXPECT_EQ(packing.cell.matrix(), h) << xy << ' ' << xz << ' ' << yz;
                EXPECT_EQ(packing.positions[0], Vec3(0, 0, 1));
            }
}

TEST(LammpsDump, WritesTheBoxAroundTheCell) {
    const ScratchFolder folder;
    for (const double sign : {-1.0, 1.0}) {
        Packing packing = example_packing(1);
        Mat3 h;
        h << 8.0, sign * 1.5, -sign * 2.25, 0.0, 4.0, sign * 0.5, 0.0, 0.0, 5.0;
        packing.cell = PeriodicCell(h);
        write_lammps_dump(packing, folder / "packing.dump");
        const std::string expected = header_of(h, Vec3::Zero());
        const std::string bounds = expected.substr(expected.find("ITEM: BOX"));
        EXPECT_THAT(content_of(folder / "packing.dump"), HasSubstr(bounds));
    }
}

TEST(LammpsDump, TheLastFrameUnlessToldOtherwise) {
    const std::string later = replaced(replaced(dump_spheres, "700", "900"), "0.75", "2");
    EXPECT_EQ(read_dump_text(dump_spheres + later).step, 900);
    EXPECT_EQ(read_dump_text(dump_spheres + later).diameters[0], 4.0);
    EXPECT_EQ(read_dump_text(dump_spheres + later, 0).step, 700);
    EXPECT_EQ(read_dump_text(dump_spheres + later, 1).step, 900);
    EXPECT_THAT(refusal_of_dump(dump_spheres + later, 2), HasSubstr("holds 2 frames"));
}

TEST(LammpsDump, RoundTripKeepsEveryValue) {
    const ScratchFolder folder;
    const Packing saved = example_packing(2000);
    write_lammps_dump(saved, folder / "packing.dump");
    const Packing read = read_lammps_dump(folder / "packing.dump");
    EXPECT_EQ(read.positions, saved.positions);
    EXPECT_EQ(read.velocities, saved.velocities);
    EXPECT_EQ(read.diameters, saved.diameters);
    EXPECT_EQ(read.ids, saved.ids);
    EXPECT_EQ(read.step, saved.step);
    // The bounds of a tilted cell are sums, which round.
    EXPECT_TRUE(read.cell.matrix().isApprox(saved.cell.matrix(), 1e-15));
}

TEST(LammpsDump, ShiftsIdsThatLammpsWouldRefuse) {
    const ScratchFolder folder;
    Packing packing = example_packing(3);
    packing.ids = {0, 2, 1};
    packing.velocities.clear();
    write_lammps_dump(packing, folder / "packing.dump");
    EXPECT_THAT(read_lammps_dump(folder / "packing.dump").ids, ElementsAre(1, 3, 2));
}

TEST(LammpsDump, ReadsWhatLammpsWrote) {
    std::ifstream file(packing_folder + "expected.json");
    const nlohmann::json expected = nlohmann::json::parse(file);
    for (const auto& [name, values] : expected.items()) {
        const Packing packing = read_lammps_dump(packing_folder + name);
        EXPECT_EQ(packing.size(), values["N"].get<Count>());
        const Mat3& h = packing.cell.matrix();
        const std::array<double, 3> tilt = {h(0, 1) / h(0, 0), h(0, 2) / h(0, 0),
                                            h(1, 2) / h(1, 1)};
        const auto expected_tilt = values["tilt"].get<std::array<double, 3>>();
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(tilt[k], expected_tilt[k], 1e-12);
        double solid = 0.0;
        for (const double diameter : packing.diameters)
            solid += std::numbers::pi / 6.0 * diameter * diameter * diameter;
        const double phi = values["phi"].get<double>();
        EXPECT_NEAR(solid / packing.cell.volume(), phi, 1e-12);
    }
}

TEST(LammpsDump, SaysFileLineAndRemedy) {
    const auto refusal = [](std::string_view part, std::string_view by) {
        return refusal_of_dump(replaced(dump_spheres, part, by));
    };
    EXPECT_THAT(refusal("0.75", "nan"), AllOf(HasSubstr("some.dump:10:"), HasSubstr("radius")));
    EXPECT_THAT(refusal("0.75", "0"), HasSubstr("above zero"));
    EXPECT_THAT(refusal("0.75", "0.7.5"), HasSubstr("'0.7.5'"));
    EXPECT_THAT(refusal("0 -4 6", "0 12 6"), HasSubstr("lines 10 and 11 both have the id 12"));
    EXPECT_THAT(refusal("12 3", "12.5 3"), HasSubstr("whole number"));
    EXPECT_THAT(refusal("ATOMS\n2", "ATOMS\n3"), HasSubstr("ends after 2 of 3 atoms"));
    EXPECT_THAT(refusal("ATOMS\n2", "ATOMS\n1"), HasSubstr("some.dump:11:"));
    EXPECT_THAT(refusal("ATOMS\n2", "ATOMS\n-2"), HasSubstr("number of spheres"));
    EXPECT_THAT(refusal(" 3 -1\n", "\n"), HasSubstr("7 of 9 columns"));
    EXPECT_THAT(refusal("3 -1\n", "3 -1 4\n"), HasSubstr("more than 9 columns"));
    EXPECT_THAT(refusal("z y x", "z ys x"), HasSubstr("some positions are scaled"));
    EXPECT_THAT(refusal("pp pp pp", "pp ff pp"), HasSubstr("not periodic"));
    EXPECT_THAT(refusal("-1 9", "9 -1"), HasSubstr("above zero"));
    EXPECT_THAT(refusal("-1 9", "-1 inf"), HasSubstr("finite"));
    EXPECT_THAT(refusal("radius", "size"), HasSubstr("give diameter or radius"));
    EXPECT_THAT(refusal("radius", "x"), HasSubstr("two columns hold x"));
    EXPECT_THAT(refusal("vx id z", "q id z"), HasSubstr("give all or none"));
    EXPECT_THAT(refusal("ITEM: TIMESTEP", "LAMMPS data"), HasSubstr("some.dump:1:"));
    EXPECT_THAT(refusal_of_dump(""), HasSubstr("the file is empty"));
    EXPECT_THAT(refusal_of_dump(std::string(3 << 20, 'x')), HasSubstr("longer than a line"));
}

TEST(LammpsDump, AnyTruncationIsRefused) {
    const std::size_t last_row = dump_spheres.rfind(" 0 1 0");
    for (std::size_t length = 0; length < last_row; ++length)
        EXPECT_NE(refusal_of_dump(dump_spheres.substr(0, length)), "") << length;
}

}  // namespace
}  // namespace jam
