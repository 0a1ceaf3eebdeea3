// SPDX-License-Identifier: BSD-3-Clause
// Scenes to text: what is written reads back the same; templates, reference and shipped scenes.
#include "core/check.h"
#include "jamming/scene_file.h"
#include "jamming/scene_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace jam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Texts = std::vector<std::string>;

const std::filesystem::path data = WIDEJAM_DATA_DIR;

std::string content(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Scenes of every kind, none of whose values is the default where it can be another.
std::vector<Scene> scenes() {
    const Texts other = {"contact.law=hertz",
                         "contact.stiffness=3.3",
                         "contact.damping=0.1",
                         "contact.density=0.7",
                         "protocol.pressure=[1e-6,2e-6,3e-6,1e-7,-2e-7,3e-7]",
                         "protocol.time_step=0.02",
                         "protocol.masses=equal",
                         "protocol.cell_inertia=0.1",
                         "protocol.cell_damping=0",
                         "protocol.kind=nph",
                         "protocol.compaction_pressure=0.02",
                         "protocol.compaction_steps=17",
                         "protocol.descent_rate=0.003",
                         "protocol.descent_cundall=0.002",
                         "stop.pressure=0.1",
                         "stop.cundall=0.30000000000000004",
                         "stop.kinetic_energy=1e-300",
                         "stop.volume_fraction_change=1e-7",
                         "stop.coordination_change=1",
                         "stop.window=5",
                         "stop.max_steps=9223372036854775807",
                         "stop.max_time=0.1",
                         "run.seed=9223372036854775807",
                         "run.threads=3",
                         "run.record_interval=7",
                         "run.checkpoint_interval=11",
                         "run.output=a \"b\" \\c\n\x7f",
                         "start.volume_fraction=0.1"};
    const std::vector<Texts> kinds = {
        {"sizes.kind=power-law", "sizes.size_ratio=7", "sizes.beta=3.3", "sizes.draw=random"},
        {"sizes.kind=binary", "sizes.size_ratio=3", "sizes.small_fraction=0.1",
         "sizes.large_count=9"},
        {"sizes.kind=monodisperse", "sizes.count=77"},
        {"sizes.kind=grain-size-distribution", "sizes.size_ratio=3", "sizes.eta=0.7"},
        {"sizes.kind=lognormal", "sizes.sigma=0.1", "sizes.count=50"},
    };
    std::vector<Scene> out;
    for (const Texts& kind : kinds) {
        Texts all = other;
        all.insert(all.end(), kind.begin(), kind.end());
        out.push_back(parse_scene("", "scene.toml", kind));
        out.push_back(parse_scene("", "scene.toml", all));
    }
    return out;
}

TEST(SceneText, ReadsBackTheSame) {
    for (const Scene& scene : scenes()) {
        const std::string text = scene_text(scene);
        const Scene again = parse_scene(text, "scene.toml");
        EXPECT_THAT(scene_differences(again, scene), IsEmpty()) << text;
        EXPECT_EQ(scene_text(again), text);
        EXPECT_EQ(again.protocol.pressure, scene.protocol.pressure);
        EXPECT_EQ(again.stop.cundall, scene.stop.cundall);
        EXPECT_EQ(again.run.output, scene.run.output);
        EXPECT_EQ(draw_diameters(again), draw_diameters(scene));
    }
}

TEST(SceneText, ATableAndItsWeightReadBackTheSame) {
    const auto folder = std::filesystem::temp_directory_path() / "widejam_scene_text_table";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "curve.csv") << "1, 0\n2, 0.5\n3, 1\n";
    const Scene scene = parse_scene("[sizes]\nkind='table'\nfile='curve.csv'\nweight='number'\n",
                                    folder / "scene.toml");
    const Scene again = parse_scene(scene_text(scene), "elsewhere/scene.toml", {});
    EXPECT_EQ(std::get<CumulativeCurve>(again.sizes.distribution).given, Weight::number);
    EXPECT_EQ(draw_diameters(again), draw_diameters(scene));
    std::filesystem::remove_all(folder);
}

TEST(SceneText, EveryKeyThatWasSetIsWritten) {
    const Scene scene = scenes()[1];
    for (const SceneKey& key : scene_keys()) {
        const bool foreign =
            key.name.starts_with("sizes.") && !find_sizes_kind("power-law")->takes(key.name);
        if (foreign || key.name == "sizes.beta" || key.name == "sizes.count" ||
            key.name == "start.packing")
            continue;
        EXPECT_THAT(scene_text(scene),
                    HasSubstr(fmt::format("\n{} = ", key.name.substr(key.name.find('.') + 1))));
    }
}

TEST(SceneText, DifferencesNameKeyAndValues) {
    const Scene was = scenes()[0];
    Scene now = was;
    now.protocol.pressure = Mat3::Identity() * 1e-5;
    now.run.output = "here";
    EXPECT_THAT(scene_differences(now, was),
                testing::ElementsAre("protocol.pressure = 1e-5 (was 1e-6)",
                                     "run.output = \"here\" (was nothing)"));
}

TEST(SceneTemplate, OfEveryKindReadsAsAScene) {
    for (const SizesKind& kind : sizes_kinds()) {
        const std::string text = scene_template(kind.name);
        if (kind.name == "table") {
            EXPECT_THAT(text, HasSubstr("file = \"diameters.csv\""));
            continue;
        }
        const Scene scene = parse_scene(text, "scene.toml");
        EXPECT_EQ(kind_name(scene.sizes.distribution), kind.name);
        EXPECT_GE(particle_count(scene.sizes), 1);
    }
}

TEST(SceneTemplate, CommentsEveryKeyAndHoldsTheDefaults) {
    const Scene scene = parse_scene(scene_template("power-law"), "scene.toml");
    const Scene bare = parse_scene(
        "", "scene.toml", Texts{"sizes.kind=power-law", "sizes.alpha=0.55", "sizes.size_ratio=5"});
    EXPECT_THAT(scene_differences(scene, bare), IsEmpty());
    for (const SceneKey& key : scene_keys()) {
        if (key.name.starts_with("sizes.")) continue;
        EXPECT_THAT(scene_template("power-law"), HasSubstr(fmt::format("# {}", key.meaning)));
    }
}

TEST(SceneTemplate, AnUnknownKindIsAnsweredWithTheKnownOnes) {
    try {
        scene_template("bimodal");
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("bimodal"));
        EXPECT_THAT(error.what(), HasSubstr("\"binary\""));
    }
}

TEST(SceneReference, StandsInTheDocumentationWordForWord) {
    const std::string document = content(data.parent_path() / "docs/scene.md");
    EXPECT_THAT(document, HasSubstr(scene_reference()))
        << "put the output of 'jam_app keys' into docs/scene.md";
}

TEST(ShippedScenes, AllCanBeRun) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(data / "scenes")) {
        if (entry.path().extension() != ".toml") continue;
        ++count;
        const Scene scene = read_scene(entry.path());
        EXPECT_GE(particle_count(scene.sizes), 1) << entry.path();
    }
    EXPECT_GE(count, 4);
}

TEST(ShippedScenes, TheQuickstartIsThePapersSmallestPowerLaw) {
    const Scene scene = read_scene(data / "scenes/quickstart.toml");
    EXPECT_NEAR(static_cast<double>(particle_count(scene.sizes)), 3800, 100);
}

}  // namespace
}  // namespace jam
