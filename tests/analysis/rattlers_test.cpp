// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/rattlers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace jam {
namespace {

using testing::Each;
using testing::ElementsAre;

using Pairs = std::vector<std::pair<Index, Index>>;

std::vector<Contact> contacts_of(const Pairs& pairs) {
    std::vector<Contact> contacts;
    for (const auto& [first, second] : pairs)
        contacts.push_back({first, second, Image::Zero(), 0.1, 0.1, Vec3::UnitX()});
    return contacts;
}

Rattlers rattlers_of(Index particle_count, const Pairs& pairs, int threshold = 3) {
    const std::vector<Contact> contacts = contacts_of(pairs);
    return find_rattlers(contacts, contact_rows(particle_count, contacts), threshold);
}

const Pairs tetrahedron = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

TEST(Rattlers, ATetrahedronHoldsAtThreeAndFallsAtFour) {
    const Rattlers at_three = rattlers_of(4, tetrahedron);
    EXPECT_THAT(at_three.is_rattler, Each(0));
    EXPECT_THAT(at_three.contact_counts_nr, Each(3));
    EXPECT_EQ(at_three.contact_count_nr, 6);
    const Rattlers at_four = rattlers_of(4, tetrahedron, 4);
    EXPECT_THAT(at_four.is_rattler, Each(1));
    EXPECT_EQ(at_four.contact_count_nr, 0);
    EXPECT_EQ(at_four.backbone_count(), 0);
}

TEST(Rattlers, RemovalGoesOnUntilNoneIsLeft) {
    // A chain 4-5-6-7 hangs on the tetrahedron. 5 and 6 have three contacts at first, through
    // their common neighbor 8, and fall only when the ends of the chain have fallen.
    Pairs pairs = tetrahedron;
    pairs.insert(pairs.end(), {{3, 4}, {4, 5}, {5, 6}, {6, 7}, {5, 8}, {6, 8}});
    const Rattlers rattlers = rattlers_of(10, pairs);
    EXPECT_THAT(rattlers.is_rattler, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 1, 1));
    EXPECT_THAT(rattlers.contact_counts_nr, ElementsAre(3, 3, 3, 3, 0, 0, 0, 0, 0, 0));
    EXPECT_EQ(rattlers.rattler_count, 6);
    EXPECT_EQ(rattlers.backbone_count(), 4);
    EXPECT_EQ(rattlers.contact_count_nr, 6);
}

TEST(Rattlers, ContactsWithRattlersDoNotCount) {
    // 4 touches three of the tetrahedron and stays; 5 touches two and goes.
    Pairs pairs = tetrahedron;
    pairs.insert(pairs.end(), {{0, 4}, {1, 4}, {2, 4}, {0, 5}, {3, 5}});
    const Rattlers rattlers = rattlers_of(6, pairs);
    EXPECT_THAT(rattlers.is_rattler, ElementsAre(0, 0, 0, 0, 0, 1));
    EXPECT_THAT(rattlers.contact_counts_nr, ElementsAre(4, 4, 4, 3, 3, 0));
    EXPECT_EQ(rattlers.contact_count_nr, 9);
}

TEST(Rattlers, SeveralImagesOfOnePairAreSeveralContacts) {
    const Rattlers rattlers = rattlers_of(3, {{0, 1}, {0, 1}, {0, 1}, {1, 2}});
    EXPECT_THAT(rattlers.is_rattler, ElementsAre(0, 0, 1));
    EXPECT_THAT(rattlers.contact_counts_nr, ElementsAre(3, 3, 0));
}

TEST(Rattlers, NoParticlesNoRattlers) {
    EXPECT_EQ(rattlers_of(0, {}).rattler_count, 0);
    EXPECT_EQ(rattlers_of(2, {}).rattler_count, 2);
}

}  // namespace
}  // namespace jam
