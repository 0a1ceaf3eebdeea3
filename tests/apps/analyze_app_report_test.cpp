// SPDX-License-Identifier: BSD-3-Clause
// analyze_app report as a user runs it, and its page as a browser shows it.
#include "jamming/record.h"
#include "jamming/scene_file.h"
#include "packing/packing_io.h"
#include "support/data_folders.h"
#include "support/packings.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <regex>

namespace jam {
namespace {

using namespace test;
using nlohmann::json;
using testing::HasSubstr;

ProgramRun report(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"report", "--samples", "1"});
    return run_program(WIDEJAM_ANALYZE_APP, arguments);
}

int count_of(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    return static_cast<int>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

/// Says only which text is missing: a page is long.
void expect_contains(const std::string& page, const std::string& text) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

/// A packing of power-law sizes, pressed together at random, that knows its scene.
Packing packing_of_scene(double size_ratio, std::uint64_t seed) {
    Scene scene;
    scene.sizes.distribution = PowerLaw{size_ratio, 0.6};
    scene.sizes.count = 250;
    Packing packing = random_spheres(random_edges(3.2 * size_ratio, seed), 250, size_ratio, seed);
    packing.diameters = draw_diameters(scene);
    packing.provenance.scene = scene_text(scene);
    return packing;
}

/// Run folders of small packings at several sizes and seeds, as jam_app leaves them.
void make_runs(const ScratchFolder& folder) {
    for (const double ratio : {3.0, 4.0})
        for (const std::uint64_t seed : {1u, 2u}) {
            const std::filesystem::path run =
                folder.path() / ("ratio" + std::to_string(static_cast<int>(ratio)) + "_seed" +
                                 std::to_string(seed));
            std::filesystem::create_directories(run);
            write_packing(packing_of_scene(ratio, seed), run / "packing.h5");
            std::ofstream records(run / "record.jsonl");
            for (int k = 1; k < 20; ++k) {
                Record record;
                record.time = k;
                record.volume_fraction = 0.7 - 0.3 / k;
                record.coordination = record.coordination_nr = 6.0 - 1.0 / k;
                record.cundall = 1.0 / k;
                record.pressure = Mat3::Identity();
                records << json_line(record) << "\n";
            }
        }
}

TEST(AnalyzeReport, OfOnePackingIsOneFileWithEverything) {
    const ScratchFolder folder;
    const ProgramRun run =
        report({packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump", "-o", folder / "out"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("report.html"));
    const std::string page = content_of(folder / "out/report.html");
    expect_contains(page, "Not jammed");
    expect_contains(page, "0.7188");  // its volume fraction
    expect_contains(page, "data:image/png;base64,");
    for (const char* figure : {"cumulative_volume", "pair_sizes", "size_coordination",
                               "backbone_sizes", "backbone_larger", "forces", "gaps", "radial"}) {
        expect_contains(page, std::string("<figure id=\"") + figure);
        EXPECT_TRUE(std::filesystem::exists(folder / "out" / (std::string(figure) + ".gp")));
    }
    // Nothing is fetched: no source, style or script from elsewhere.
    EXPECT_EQ(count_of(page, "(src|href)=\"(https?:)?//"), 0);
    EXPECT_EQ(count_of(page, "<(script|iframe|object)"), 0);
    EXPECT_EQ(count_of(page, "@import|url\\(http"), 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/picture.png"));
}

TEST(AnalyzeReport, OfARunShowsItsHistory) {
    const ScratchFolder folder;
    make_runs(folder);
    const ProgramRun run = report({folder / "ratio3_seed1/packing.h5", "-o", folder / "out"});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string page = content_of(folder / "out/report.html");
    expect_contains(page, "<figure id=\"history\"");
    expect_contains(page, "<h1>ratio3_seed1</h1>");
}

TEST(AnalyzeReport, OfAFolderOfRunsAveragesOverSeeds) {
    const ScratchFolder folder;
    make_runs(folder);
    const ProgramRun run = report({folder.path(), "-o", folder / "out"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("4/4"));
    const std::string page = content_of(folder / "out/report.html");
    for (const char* figure : {"volume_fraction", "coordination", "backbone_volume_fraction",
                               "backbone_larger_by_size_ratio", "onset",
                               "size_coordination_by_alpha", "backbone_sizes_by_alpha"})
        expect_contains(page, std::string("<figure id=\"") + figure);
    expect_contains(page, "4 packings");
    expect_contains(page, "λ = 3, α = 0.6");
    expect_contains(page, "λ = 4, α = 0.6");
}

TEST(AnalyzeReport, SaysWhatIsWrong) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "empty");
    for (const std::filesystem::path& packing : {folder / "nothing.h5", folder / "empty"}) {
        const ProgramRun run = report({packing, "-o", folder / "out"});
        EXPECT_EQ(run.status, 2);
        EXPECT_THAT(run.err, HasSubstr(packing.string()));
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

TEST(AnalyzeReport, SaysWhichOfManyCannotBeMeasured) {
    const ScratchFolder folder;
    write_packing(face_centered_cubic(3, 1.41, 1.0), folder / "good.csv");
    // Wider than its cell.
    write_packing(make_packing(Mat3::Identity(), {Vec3(0.2, 0.2, 0.2)}, {1.1}), folder / "bad.csv");
    const ProgramRun run = report({folder / "good.csv", folder / "bad.csv", "-o", folder / "out"});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("bad.csv: cell"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

/// Looks at every figure once the page stands, and leaves what it saw in the page.
constexpr const char* onlooker = R"html(<script>
addEventListener("load", () => {
  const seen = [...document.querySelectorAll("figure")].map(f => {
    const drawing = f.querySelector("svg, img"), box = drawing ? drawing.getBoundingClientRect() : null;
    return { id: f.id, drawn: !!box && box.width > 100 && box.height > 100 &&
      (drawing.tagName === "IMG" ? drawing.complete && drawing.naturalWidth > 0
                                 : drawing.querySelectorAll("path").length > 10) };
  });
  const note = document.createElement("pre");
  note.id = "onlooker";
  note.textContent = "SEEN" + JSON.stringify({ seen, wide: document.documentElement.scrollWidth > innerWidth }) + "NEES";
  document.body.append(note);
});
</script>)html";

class AnalyzeReportInABrowser : public testing::Test {
  protected:
    void SetUp() override {
        if (std::system("command -v chromium >/dev/null 2>&1") != 0)
            GTEST_SKIP() << "chromium is not installed: the page is not looked at";
        if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
            GTEST_SKIP() << "gnuplot is not installed: there is no figure to look at";
    }

    /// Opens a page with the onlooker in it.
    static ProgramRun open(const std::filesystem::path& page, const ScratchFolder& folder) {
        const std::filesystem::path watched = page.parent_path() / "watched.html";
        std::string text = content_of(page);
        text.insert(text.rfind("</body>"), onlooker);
        std::ofstream(watched) << text;
        return run_program(
            "chromium",
            {"--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
             "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--enable-logging=stderr", "--window-size=1200,900",
             "--user-data-dir=" + (folder / "profile").string(), "--virtual-time-budget=10000",
             "--dump-dom", "file://" + watched.string()});
    }

    static void expect_all_drawn(const std::filesystem::path& page, int figures) {
        const ScratchFolder folder;
        const ProgramRun run = open(page, folder);
        EXPECT_EQ(run.err.find("CONSOLE"), std::string::npos) << run.err.substr(0, 2000);
        std::smatch found;
        ASSERT_TRUE(std::regex_search(run.out, found, std::regex("SEEN(\\{.*\\})NEES")))
            << run.err.substr(0, 2000);
        const json seen = json::parse(found[1].str());
        EXPECT_FALSE(seen["wide"]) << "the page is wider than its window";
        EXPECT_EQ(seen["seen"].size(), static_cast<std::size_t>(figures));
        for (const json& figure : seen["seen"]) EXPECT_TRUE(figure["drawn"]) << figure;
    }
};

TEST_F(AnalyzeReportInABrowser, EveryFigureOfOnePackingIsDrawn) {
    const ScratchFolder folder;
    ASSERT_EQ(report({packing_folder + "lammps_lambda5_alpha0.6_p5e-3.dump", "-o", folder / "out"})
                  .status,
              0);
    expect_all_drawn(folder / "out/report.html", 1 + 8);
}

TEST_F(AnalyzeReportInABrowser, EveryFigureOfManyPackingsIsDrawn) {
    const ScratchFolder folder;
    make_runs(folder);
    ASSERT_EQ(report({folder.path(), "-o", folder / "out"}).status, 0);
    expect_all_drawn(folder / "out/report.html", 2 + 7);
}

}  // namespace
}  // namespace jam
