// SPDX-License-Identifier: BSD-3-Clause
#include "sizes/size_table.h"

#include "core/check.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
namespace jam {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class SizeTable : public testing::Test {
  protected:
    SizeDistribution read(const std::string& text, Weight given = Weight::volume) {
        std::ofstream(path, std::ios::binary) << text;
        return read_size_table(path, given);
    }

    std::string complaint(const std::string& text) {
        try {
            read(text);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    test::ScratchFolder folder;
    std::filesystem::path path = folder / "sizes.csv";
};

TEST_F(SizeTable, OneColumnIsAListOfDiameters) {
    const auto list =
        std::get<DiameterList>(read("diameter\n2.5\n1e0\n# a remark\n\n4 # another\n"));
    EXPECT_THAT(list.diameters, ElementsAre(1.0, 2.5, 4.0));
    EXPECT_EQ(list.volume_fractions.back(), 1.0);
}

TEST_F(SizeTable, TwoColumnsAreACumulativeCurve) {
    const auto curve = std::get<CumulativeCurve>(read("D,fraction\n1,0\n2,0.25\n4,1\n"));
    EXPECT_EQ(curve.given, Weight::volume);
    EXPECT_THAT(curve.diameters, ElementsAre(1.0, 2.0, 4.0));
    EXPECT_THAT(curve.volume_fractions, ElementsAre(0.0, 0.25, 1.0));
    const double below = 0.25 / 1.0 * 0.5 * (1.0 - 1.0 / 4.0);  // slope times integral of D^-3
    const double above = 0.75 / 2.0 * 0.5 * (1.0 / 4.0 - 1.0 / 16.0);
    EXPECT_NEAR(curve.number_fractions[1], below / (below + above), 1e-14);
}

TEST_F(SizeTable, TheCurveMayCountParticles) {
    const auto curve = std::get<CumulativeCurve>(read("1 0\n2 0.5\n4 1\n", Weight::number));
    EXPECT_THAT(curve.number_fractions, ElementsAre(0.0, 0.5, 1.0));
    const double below = 0.5 / 1.0 * (16.0 - 1.0);  // slope times integral of 4 D^3
    const double above = 0.5 / 2.0 * (256.0 - 16.0);
    EXPECT_NEAR(curve.volume_fractions[1], below / (below + above), 1e-14);
}

TEST_F(SizeTable, WritersOfOtherSystemsAreUnderstood) {
    const auto list =
        std::get<DiameterList>(read("\xEF\xBB\xBF"
                                    "1.5\r\n2\r\n"));
    EXPECT_THAT(list.diameters, ElementsAre(1.5, 2.0));
    EXPECT_TRUE(std::holds_alternative<CumulativeCurve>(read("\"D\";\"F\"\r\n1;0\r\n3;1")));
}

TEST_F(SizeTable, MistakesAreAnsweredWithTheirLine) {
    EXPECT_THAT(complaint("1\n2\n-3\n"), AllOf(HasSubstr("line 3"), HasSubstr("-3")));
    EXPECT_THAT(complaint("# sizes\n1\nnan\n"), AllOf(HasSubstr("line 3"), HasSubstr("nan")));
    EXPECT_THAT(complaint("1\n0\n"), HasSubstr("line 2"));
    EXPECT_THAT(complaint("1\ntwo\n"), AllOf(HasSubstr("line 2"), HasSubstr("'two'")));
    EXPECT_THAT(complaint("1.0x\n2\n"), AllOf(HasSubstr("line 1"), HasSubstr("1.0x")));
    EXPECT_THAT(complaint("name\nother name\n2\n"), HasSubstr("line 2"));
    EXPECT_THAT(complaint("1,0\n2\n"), AllOf(HasSubstr("line 2"), HasSubstr("1 columns")));
    EXPECT_THAT(complaint("1,0,5\n"), AllOf(HasSubstr("line 1"), HasSubstr("3 columns")));
    EXPECT_THAT(complaint("1,0\n2,0.7\n3,0.6\n4,1\n"),
                AllOf(HasSubstr("line 3"), HasSubstr("0.6")));
    EXPECT_THAT(complaint("1,0\n3,0.5\n2,1\n"), AllOf(HasSubstr("line 3"), HasSubstr("sort")));
    EXPECT_THAT(complaint("1,0\n2,50\n3,100\n"), AllOf(HasSubstr("line 3"), HasSubstr("percent")));
    EXPECT_THAT(complaint("1,0.1\n2,1\n"), AllOf(HasSubstr("line 1"), HasSubstr("0.1")));
    EXPECT_THAT(complaint("1,0\n2,1\n3,1\n"), HasSubstr("line 3"));
    EXPECT_THAT(complaint("1,0\n"), HasSubstr("at least 2"));
    EXPECT_THAT(complaint("1,0\n2,nan\n3,1\n"), HasSubstr("nan"));
    EXPECT_THAT(complaint("1\n1e6\n"), HasSubstr("times the smallest"));
    EXPECT_THAT(complaint("# nothing\n\n"), HasSubstr("holds no numbers"));
    EXPECT_THAT(complaint("heading only\n"), HasSubstr("holds no numbers"));
}

TEST_F(SizeTable, AFileThatCannotBeReadIsSaid) {
    EXPECT_THROW(read_size_table("/nowhere/sizes.csv"), FileError);
    EXPECT_THROW(read_size_table(folder.path()), FileError);
}

TEST_F(SizeTable, NumbersGivenDirectlyFollowTheSameRules) {
    EXPECT_THROW(diameter_list({}), InputError);
    EXPECT_THROW(diameter_list({1.0, INFINITY}), InputError);
    EXPECT_THROW(cumulative_curve({1.0, 2.0}, {0.0}, Weight::volume), InputError);
    EXPECT_THROW(cumulative_curve({}, {}, Weight::volume), InputError);
    EXPECT_THROW(cumulative_curve({2.0, 1.0}, {0.0, 1.0}, Weight::volume), InputError);
}

}  // namespace
}  // namespace jam
