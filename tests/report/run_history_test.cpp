// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_history.h"

#include "core/check.h"
#include "jamming/record.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace jam {
namespace {

using testing::HasSubstr;

Record record_at(double time) {
    Record record;
    record.step = static_cast<Count>(100 * time);
    record.time = time;
    record.volume_fraction = 0.7;
    record.coordination_nr = 6.01;
    record.pressure = Mat3::Identity() * 1e-3;
    record.pressure(0, 0) = 4e-3;
    return record;
}

TEST(RunHistory, ReadsWhatRunsWrite) {
    const test::ScratchFolder folder;
    std::ofstream(folder / "record.jsonl") << json_line(record_at(1.0)) << "\n"
                                           << json_line(record_at(2.5)) << "\n";
    const Table history = read_run_history(folder / "record.jsonl");
    ASSERT_EQ(history.columns.size(), 7u);
    EXPECT_EQ(history.columns[0].values, (std::vector<double>{100, 250}));
    EXPECT_EQ(history.columns[1].values, (std::vector<double>{1.0, 2.5}));
    EXPECT_EQ(history.columns[2].values, (std::vector<double>{0.7, 0.7}));
    EXPECT_TRUE(std::isnan(history.columns[3].values[0]));
    EXPECT_EQ(history.columns[4].values[1], 6.01);
    EXPECT_DOUBLE_EQ(history.columns[6].values[0], 2e-3);
}

TEST(RunHistory, ThinsEvenlyAndKeepsBothEnds) {
    const test::ScratchFolder folder;
    std::ofstream file(folder / "record.jsonl");
    for (int k = 0; k <= 1000; ++k) file << json_line(record_at(k)) << "\n";
    file.close();
    const std::vector<double> times =
        read_run_history(folder / "record.jsonl", 11).columns[1].values;
    EXPECT_EQ(times, (std::vector<double>{0, 100, 200, 300, 400, 500, 600, 700, 800, 900, 1000}));
}

TEST(RunHistory, SaysWhichLineIsNoRecord) {
    const test::ScratchFolder folder;
    const auto file = folder / "record.jsonl";
    std::ofstream(file) << json_line(record_at(1.0)) << "\n{\"time\": 2}\n";
    try {
        read_run_history(file);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("record.jsonl:2"));
    }
    EXPECT_THROW(read_run_history(folder / "nothing.jsonl"), FileError);
}

}  // namespace
}  // namespace jam
