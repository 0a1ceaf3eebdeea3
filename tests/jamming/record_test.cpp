// SPDX-License-Identifier: BSD-3-Clause
// Records and verdicts as JSON.
#include "jamming/record.h"

#include "core/check.h"
#include "jamming/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace jam {
namespace {

using testing::HasSubstr;

Record example() {
    Record record;
    record.step = 123456789012;
    record.time = 0.1 + 0.2;
    record.volume_fraction = 0.639;
    record.pressure << 1, 2, 3, 2, 4, 5, 3, 5, 6;
    record.pressure_dynamic = 1.5 * record.pressure;
    record.cell << 10, 1, 2, 0, 11, 3, 0, 0, 12;
    record.cundall = 1e-300;
    return record;
}

TEST(Record, ReadsBackTheSameBits) {
    const Record record = example();
    const Record again = record_from_json(json_line(record));
    EXPECT_EQ(again.step, record.step);
    EXPECT_EQ(again.time, record.time);
    EXPECT_EQ(again.pressure, record.pressure);
    EXPECT_EQ(again.pressure_dynamic, record.pressure_dynamic);
    EXPECT_EQ(again.cell, record.cell);
    EXPECT_EQ(again.cundall, record.cundall);
    EXPECT_EQ(json_line(again), json_line(record));
}

TEST(Record, IsOneLineWhoseCellHasTheEdgesAsRows) {
    const std::string line = json_line(example());
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_THAT(line, HasSubstr(R"("cell":[[10.0,0.0,0.0],[1.0,11.0,0.0],[2.0,3.0,12.0]])"));
}

TEST(Record, WhatIsNotKnownIsNull) {
    const std::string line = json_line(example());
    EXPECT_THAT(line, HasSubstr(R"("coordination_nr":null)"));
    EXPECT_TRUE(std::isnan(record_from_json(line).coordination_nr));
}

TEST(Record, OtherLinesAreRefused) {
    for (const char* line : {"", "{", "{}", "[]", "3", R"({"step": "x"})"})
        EXPECT_THROW(record_from_json(line), InputError) << line;
}

Verdict two_criteria(bool second_holds) {
    return {{{"pressure", 1e-5, 1e-4, true}, {"cundall", std::nan(""), 1e-6, second_holds}}};
}

TEST(Verdict, NeedsEveryCriterion) {
    EXPECT_TRUE(two_criteria(true).converged());
    EXPECT_FALSE(two_criteria(false).converged());
    EXPECT_FALSE(Verdict{}.converged());
}

TEST(Verdict, ReadsBackFromJson) {
    const Verdict again = verdict_from_json(to_json(two_criteria(false)));
    ASSERT_EQ(again.criteria.size(), 2u);
    EXPECT_EQ(again.criteria[0].name, "pressure");
    EXPECT_EQ(again.criteria[0].value, 1e-5);
    EXPECT_TRUE(again.criteria[0].holds);
    EXPECT_TRUE(std::isnan(again.criteria[1].value));
    EXPECT_FALSE(again.criteria[1].holds);
    EXPECT_FALSE(nlohmann::json::parse(to_json(again)).at("converged").get<bool>());
    EXPECT_THROW(verdict_from_json("{}"), InputError);
}

TEST(Verdict, TellsPeopleWhichCriteriaHold) {
    const std::string text = to_text(two_criteria(false));
    EXPECT_THAT(text, testing::ContainsRegex("pressure .*1.000e-05.*<= 0.0001.* holds\n"));
    EXPECT_THAT(text, testing::ContainsRegex("cundall .*does not hold\n"));
}

}  // namespace
}  // namespace jam
