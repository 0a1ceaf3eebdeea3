// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/elasticity.h"

#include "analysis/unheld.h"
#include "support/packings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

TEST(FindElasticity, SpeaksOfThoseThatFourHoldWhereTheStricterTestLeavesNone) {
    const Packing slab = test::cubic_slab();
    const ForceNetwork network = find_force_network(slab);
    ASSERT_EQ(find_unheld(network.contacts, network.rows).backbone_count(), 0);
    const Elasticity elasticity = find_elasticity(slab, network);
    EXPECT_EQ(elasticity.particle_count, 27);
    EXPECT_FALSE(elasticity.stability.stable);
    EXPECT_TRUE(std::isnan(elasticity.moduli.bulk));
}

}  // namespace
}  // namespace jam
