// SPDX-License-Identifier: BSD-3-Clause
// What a handoff says; that LAMMPS takes it so is tested with LAMMPS itself (tests/interop).
#include "handoff/handoff.h"

#include "jamming/rejam.h"
#include "jamming/scene_file.h"
#include "neighbors/verlet_lists.h"
#include "packing/packing_file.h"
#include "packing/packing_io.h"
#include "support/example_packings.h"
#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

namespace jam {
namespace {

using namespace jam::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const char* const power_law_scene = R"(
[sizes]
kind = "power-law"
alpha = 0.5
size_ratio = 20
count = 300
)";

class Handoff : public testing::Test {
  protected:
    std::filesystem::path folder() const { return scratch_ / "handed"; }
    void hand_over(const std::string& text, const std::vector<std::string>& overrides = {}) const {
        write_handoff(parse_scene(text, scratch_ / "scene.toml", overrides), folder());
    }
    std::string content(const char* name) const { return content_of(folder() / name); }

    ScratchFolder scratch_;
};

TEST_F(Handoff, HoldsTheStartWithTheMassesOfTheScene) {
    hand_over(power_law_scene, {"contact.density=2", "protocol.masses=equal"});
    const Scene scene = parse_scene(power_law_scene, "scene.toml");
    const std::vector<double> diameters = draw_diameters(scene);
    const std::string data = content("start.data");
    EXPECT_THAT(data, HasSubstr("300 atoms"));
    // As heavy as the smallest: the density falls with the volume.
    const double smallest = *std::min_element(diameters.begin(), diameters.end());
    const double density = 2.0 * std::pow(smallest / diameters[0], 3);
    const std::size_t first = data.find("\n1 1 ");
    std::array<double, 2> given{};
    ASSERT_EQ(std::sscanf(data.c_str() + first, " 1 1 %lf %lf", given.data(), &given[1]), 2);
    EXPECT_EQ(given[0], diameters[0]);
    EXPECT_NEAR(given[1], density, 1e-12 * density);
}

/// What LAMMPS is told when the search has these collections.
std::string interval_words(const ListSettings& lists) {
    const std::vector<double> diameters =
        draw_diameters(parse_scene(power_law_scene, "scene.toml"));
    const std::vector<double> upper = list_collections(diameters, lists).upper;
    return fmt::format("collection/interval {} {}\n", upper.size(), fmt::join(upper, " "));
}

TEST_F(Handoff, UsesTheCollectionsOfTheSearch) {
    hand_over(power_law_scene);
    EXPECT_THAT(content("system.in"),
                AllOf(HasSubstr("multi"), HasSubstr(interval_words({})),
                      HasSubstr("pair_style      gran/hooke 1 NULL 0.5 0.0 0.0 0 limit_damping")));
}

TEST_F(Handoff, UsesTheCollectionsThatTheSceneAsksFor) {
    hand_over(power_law_scene, {"run.collection_ratio=2"});
    ASSERT_NE(interval_words({.collection_ratio = 2.0}), interval_words({}));
    EXPECT_THAT(content("system.in"), HasSubstr(interval_words({.collection_ratio = 2.0})));
}

TEST_F(Handoff, HasOneGridForEqualSpheres) {
    hand_over("[sizes]\nkind = \"monodisperse\"\ncount = 50\n[contact]\nlaw = \"hertz\"\n");
    EXPECT_THAT(content("system.in"),
                AllOf(HasSubstr("neighbor        0.1 bin"), Not(HasSubstr("multi")),
                      HasSubstr("hertz 1 0.5"), HasSubstr("mass_velocity limit_damping")));
}

TEST_F(Handoff, FreesWhatTheSceneFrees) {
    hand_over(power_law_scene, {"protocol.free_cell=isotropic", "protocol.pressure=1e-4"});
    EXPECT_THAT(content("run.in"), AllOf(HasSubstr("iso 0.0001 0.0001"), Not(HasSubstr("pxy-"))));
    EXPECT_THAT(content("system.in"), Not(HasSubstr("triclinic")));
}

TEST_F(Handoff, KnowsAShearedPressure) {
    hand_over(power_law_scene, {"protocol.pressure=[1e-3,1e-3,2e-3,0,0,1e-4]"});
    EXPECT_THAT(content("run.in"), AllOf(HasSubstr("z 0.002 0.002"), HasSubstr("xy 0.0001 0.0001"),
                                         HasSubstr("nreset 1")));
    EXPECT_THAT(content("system.in"), HasSubstr("change_box      all triclinic"));
}

TEST_F(Handoff, TakesBackWhatLammpsLeaves) {
    hand_over(power_law_scene, {"contact.stiffness=2", "stop.cundall=1e-5"});
    write_packing(example_packing(20), folder() / "final.dump");
    const Scene back = read_scene(folder() / "back.toml");
    EXPECT_EQ(back.start.packing, folder() / "final.dump");
    EXPECT_EQ(back.contact.stiffness, 2.0);
    EXPECT_EQ(back.stop.cundall, 1e-5);
}

TEST_F(Handoff, NeverOverwritesOne) {
    hand_over(power_law_scene);
    const std::string before = content("start.data");
    const std::string said = refusal_of([&] { hand_over(power_law_scene, {"run.seed=2"}); });
    EXPECT_THAT(said, AllOf(HasSubstr("handed"), HasSubstr("start.data"), HasSubstr("remove")));
    EXPECT_EQ(content("start.data"), before);
}

TEST_F(Handoff, GoesOnWithTheSceneOfAPacking) {
    Packing packing = example_packing(20);
    packing.provenance.scene = scene_text(parse_scene(power_law_scene, "scene.toml", {}));
    save_packing(packing, scratch_ / "packing.h5");
    const std::vector<std::string> overrides = {"stop.max_steps=7"};
    const Scene scene = scene_from_packing(scratch_ / "packing.h5", overrides);
    EXPECT_EQ(scene.start.packing, scratch_ / "packing.h5");
    EXPECT_EQ(scene.protocol.pressure,
              parse_scene(power_law_scene, "scene.toml").protocol.pressure);
    EXPECT_EQ(scene.stop.max_steps, 7);
}

TEST_F(Handoff, TakesContactAndPressureOfAPackingWithoutAScene) {
    Packing packing = example_packing(20);
    packing.provenance.scene.clear();
    packing.material = {ContactLaw::hertz, 3.0, 0.25, 2.0};
    packing.applied_pressure = Mat3::Identity() * 0.01;
    save_packing(packing, scratch_ / "packing.h5");
    const Scene scene = scene_from_packing(scratch_ / "packing.h5");
    EXPECT_EQ(scene.contact.law, ContactLaw::hertz);
    EXPECT_EQ(scene.contact.stiffness, 3.0);
    EXPECT_EQ(scene.protocol.pressure, packing.applied_pressure);
}

}  // namespace
}  // namespace jam
