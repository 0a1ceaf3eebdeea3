// SPDX-License-Identifier: BSD-3-Clause
#include "extremes/jamming_run.h"

#include "packing/packing_io.h"
#include "support/run_program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <regex>

namespace jam::test {

namespace fs = std::filesystem;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// HDF5 files are read by the library, which takes finite numbers only.
std::string file_with_nan(const fs::path& folder) {
    static const std::regex not_finite("(^|[^a-zA-Z])-?(nan|inf|infinity)([^a-zA-Z]|$)",
                                       std::regex::icase);
    for (const char* name : {"run.log", "record.jsonl"}) {
        std::ifstream lines(folder / name);
        for (std::string line; std::getline(lines, line);)
            if (std::regex_search(line, not_finite)) return fmt::format("{}: {}", name, line);
    }
    return "";
}

double number(const nlohmann::json& json, const char* key) {
    return json.at(key).is_null() ? unknown : json.at(key).get<double>();
}

void measure(const fs::path& packing, JammingRun& run) {
    const ProgramRun stats =
        run_program(WIDEJAM_ANALYZE_APP, {"stats", "--json", packing.string()});
    ASSERT_EQ(stats.status, 0) << stats.err;
    const auto json = nlohmann::json::parse(stats.out);
    run.volume_fraction = number(json, "volume_fraction");
    run.cundall = number(json, "cundall");
    run.coordination_nr = number(json, "coordination_nr");
    run.excess_contacts =
        number(json, "contact_count_nr") - number(json, "isostatic_contact_count");
    double trace = 0.0;
    for (std::size_t k = 0; k < 3; ++k) trace += json.at("pressure").at(k).at(k).get<double>();
    run.mean_pressure = trace / 3.0;
}

}  // namespace

std::string JammingRuns::fresh_name() {
    return (folder_ / fmt::format("run{}", ++count_)).string();
}

JammingRun JammingRuns::operator()(const std::string& text, const std::vector<std::string>& sets) {
    const std::string name = fresh_name();
    std::ofstream(name + ".toml") << text;
    std::vector<std::string> arguments{"run", name + ".toml", "--out", name, "--threads", "1"};
    for (const std::string& one : sets) {
        arguments.emplace_back("--set");
        arguments.push_back(one);
    }
    const ProgramRun ran = run_program(WIDEJAM_JAM_APP, arguments);
    JammingRun run{ran.status, ran.out + ran.err, fs::exists(name), file_with_nan(name),
                   unknown,    unknown,           unknown,          unknown,
                   unknown};
    const fs::path packing = fs::path(name) / "packing.h5";
    if (fs::exists(packing)) measure(packing, run);
    return run;
}

fs::path JammingRuns::write_packing(const Packing& packing) {
    const fs::path file = fresh_name() + ".csv";
    jam::write_packing(packing, file);
    return file;
}

std::string scene_from(const fs::path& packing) {
    return fmt::format("[start]\npacking = \"{}\"\n", packing.string());
}

void expect_jammed(const JammingRun& run, double applied_pressure) {
    EXPECT_EQ(run.status, 0) << run.said;
    EXPECT_EQ(run.not_a_number, "");
    EXPECT_NEAR(run.mean_pressure, applied_pressure, 1e-4 * applied_pressure);
    EXPECT_LE(run.cundall, 1e-6);
    EXPECT_GE(run.excess_contacts, 0.0);
}

void expect_refused(const JammingRun& run, const std::vector<std::string>& words) {
    EXPECT_EQ(run.status, 2) << run.said;
    EXPECT_EQ(run.not_a_number, "");
    for (const std::string& word : words) EXPECT_THAT(run.said, testing::HasSubstr(word));
}

}  // namespace jam::test
