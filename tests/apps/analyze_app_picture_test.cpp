// SPDX-License-Identifier: BSD-3-Clause
// analyze_app picture as a user runs it.
#include "report/png_file.h"
#include "support/data_folders.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jam {
namespace {

using namespace test;
using testing::HasSubstr;

const std::string packing = test::packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump";

ProgramRun picture(const std::filesystem::path& output, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"picture", packing, "-o", output.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(WIDEJAM_ANALYZE_APP, arguments);
}

TEST(AnalyzePicture, EveryColoringGivesAPictureOfItsOwn) {
    const ScratchFolder folder;
    std::vector<std::vector<std::uint8_t>> seen;
    for (const std::string color : {"diameter", "coordination", "rattler", "force"}) {
        const ProgramRun run = picture(folder / (color + ".png"),
                                       {"--color", color, "--size", "80x60", "--samples", "2"});
        ASSERT_EQ(run.status, 0) << run.err;
        const Bitmap bitmap = read_png(folder / (color + ".png"));
        EXPECT_EQ(bitmap.width, 80);
        EXPECT_EQ(bitmap.height, 60);
        for (const auto& other : seen) EXPECT_NE(bitmap.bytes, other) << color;
        seen.push_back(bitmap.bytes);
    }
}

TEST(AnalyzePicture, EveryOptionChangesThePicture) {
    const ScratchFolder folder;
    const std::vector<std::string> small = {"--size", "80x60", "--samples", "2"};
    ASSERT_EQ(picture(folder / "plain.png", small).status, 0);
    const std::vector<std::uint8_t> plain = read_png(folder / "plain.png").bytes;
    for (const std::vector<std::string>& option : {std::vector<std::string>{"--without-rattlers"},
                                                   {"--slice", "z=0.5"},
                                                   {"--cut"},
                                                   {"--view", "x"},
                                                   {"--view", "10,-20"},
                                                   {"--without-cell"},
                                                   {"--without-legend"}}) {
        std::vector<std::string> arguments = small;
        arguments.insert(arguments.end(), option.begin(), option.end());
        ASSERT_EQ(picture(folder / "other.png", arguments).status, 0) << option[0];
        EXPECT_NE(read_png(folder / "other.png").bytes, plain) << option[0];
    }
}

TEST(AnalyzePicture, SaysWhatIsWrongWithAnOption) {
    const ScratchFolder folder;
    for (const auto& [option, value] : {std::pair("--slice", "w=0.5"),
                                        {"--slice", "z=2"},
                                        {"--slice", "z"},
                                        {"--view", "back"},
                                        {"--view", "10,120"},
                                        {"--size", "1600"},
                                        {"--size", "1x1"},
                                        {"--samples", "0"}}) {
        const ProgramRun run = picture(folder / "no.png", {option, value});
        EXPECT_EQ(run.status, 2) << option << " " << value;
        EXPECT_THAT(run.err, HasSubstr(std::string(option).substr(2))) << value;
        EXPECT_FALSE(std::filesystem::exists(folder / "no.png"));
    }
}

TEST(AnalyzePicture, WritesNoOtherKindOfFile) {
    const ScratchFolder folder;
    const ProgramRun run = picture(folder / "spheres.jpg", {});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr(".png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "spheres.jpg"));
}

}  // namespace
}  // namespace jam
