// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/rejam.h"

#include "analysis/packing_statistics.h"
#include "core/check.h"
#include "packing/packing_io.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace jam {
namespace {

Packing jammed() {
    return read_packing(std::filesystem::path(WIDEJAM_DATA_DIR) / "packings" /
                        "lammps_lambda5_alpha0.6_p5e-3.dump");
}

TEST(Rejam, WithoutRattlersTheBackboneIsLeftAsItWas) {
    const Packing packing = jammed();
    const ForceNetwork network = find_force_network(packing);
    const Packing backbone = without_rattlers(packing);
    ASSERT_EQ(backbone.size(), network.rattlers.backbone_count());
    ASSERT_LT(backbone.size(), packing.size());
    const PackingStatistics before = packing_statistics(packing, network);
    const PackingStatistics after = packing_statistics(backbone, find_force_network(backbone));
    EXPECT_EQ(after.rattler_count, 0);
    EXPECT_EQ(after.contact_count, before.contact_count_nr);
    EXPECT_NEAR(after.volume_fraction, before.volume_fraction_nr, 1e-12);
    for (const std::int64_t id : backbone.ids)
        EXPECT_EQ(std::ranges::count(packing.ids, id), 1) << id;
}

TEST(Rejam, APackingOfRattlersAloneIsRefused) {
    Packing packing;
    packing.cell = PeriodicCell(Mat3(10.0 * Mat3::Identity()));
    packing.positions = {Vec3(1, 1, 1), Vec3(5, 5, 5)};
    packing.diameters = {1.0, 1.0};
    packing.ids = {0, 1};
    EXPECT_THROW(without_rattlers(packing), InputError);
}

TEST(Rejam, TheDescentBeginsAtItsFoot) {
    Scene scene;
    scene.protocol.pressure = 3e-5 * Mat3::Identity();
    begin_at_applied_pressure(scene);
    EXPECT_EQ(scene.protocol.descent.compaction_steps, 0);
    EXPECT_DOUBLE_EQ(*scene.protocol.descent.compaction_pressure, 3e-5);
}

}  // namespace
}  // namespace jam
