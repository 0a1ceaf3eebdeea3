// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/elasticity.h"

#include "analysis/unheld.h"
#include "support/packings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

TEST(FindElasticity, SpeaksOfThoseThatFourHoldWhereTheStricterTestLeavesNone) {
    // The outer layers of a crystal with free surfaces have five contacts on one side, and once
    // they are gone so have the next ones.
    Packing slab = test::simple_cubic(3, 0.99, 1.0);
    slab.cell = PeriodicCell(Vec3(2.97, 2.97, 9.0).asDiagonal());
    const ForceNetwork network = find_force_network(slab);
    ASSERT_EQ(find_unheld(network.contacts, network.rows).backbone_count(), 0);
    const Elasticity elasticity = find_elasticity(slab, network);
    EXPECT_EQ(elasticity.particle_count, 27);
    EXPECT_FALSE(elasticity.stability.stable);
    EXPECT_TRUE(std::isnan(elasticity.moduli.bulk));
}

}  // namespace
}  // namespace jam
