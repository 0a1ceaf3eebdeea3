// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/contact_network.h"

#include "core/check.h"
#include "core/parallel.h"
#include "neighbors/brute_force_neighbors.h"
#include "support/packings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace jam {
namespace {

using namespace test;

NearPair pair_of(const Contact& contact) {
    return {contact.first, contact.second, contact.image};
}

void expect_same_contacts(const std::vector<Contact>& a, const std::vector<Contact>& b,
                          double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t c = 0; c < a.size(); ++c) {
        EXPECT_EQ(a[c].first, b[c].first);
        EXPECT_EQ(a[c].second, b[c].second);
        EXPECT_NEAR(a[c].overlap, b[c].overlap, tolerance);
        EXPECT_NEAR(a[c].force, b[c].force, tolerance);
        EXPECT_NEAR((a[c].normal - b[c].normal).norm(), 0.0, tolerance);
    }
}

/// Contacts in an order that does not depend on images, which another description of the same
/// packing numbers otherwise.
std::vector<Contact> without_images(std::vector<Contact> contacts) {
    for (Contact& contact : contacts) contact.image.setZero();
    std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
        return std::tuple(a.first, a.second, a.normal[0]) <
               std::tuple(b.first, b.second, b.normal[0]);
    });
    return contacts;
}

TEST(FindContacts, TwoSpheresByHand) {
    Packing packing =
        make_packing(Mat3::Identity() * 10.0, {{9.5, 5.0, 5.0}, {0.7, 5.9, 5.0}}, {1.0, 2.2});
    packing.material.stiffness = 3.0;
    const std::vector<Contact> contacts = find_contacts(packing);
    ASSERT_EQ(contacts.size(), 1u);
    const Contact& contact = contacts[0];
    EXPECT_EQ(pair_of(contact), (NearPair{0, 1, Image(1, 0, 0)}));
    EXPECT_NEAR(contact.overlap, 1.6 - 1.5, 1e-14);
    EXPECT_NEAR(contact.force, 0.3, 1e-13);
    EXPECT_NEAR((contact.normal - Vec3(-0.8, -0.6, 0.0)).norm(), 0.0, 1e-14);
}

TEST(FindContacts, HertzForceFromThePackingsMaterial) {
    Packing packing =
        make_packing(Mat3::Identity() * 10.0, {{5.0, 5.0, 5.0}, {7.9, 5.0, 5.0}}, {2.0, 4.0});
    packing.material.law = ContactLaw::hertz;
    packing.material.stiffness = 5.0;
    const std::vector<Contact> contacts = find_contacts(packing);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].force, 5.0 * std::sqrt(2.0 / 3.0) * std::pow(0.1, 1.5), 1e-13);
}

TEST(FindContacts, TouchingWithoutOverlapIsNoContact) {
    const Packing packing =
        make_packing(Mat3::Identity() * 8.0, {{2.0, 4.0, 4.0}, {3.0, 4.0, 4.0}}, {1.0, 1.0});
    EXPECT_TRUE(find_contacts(packing).empty());
}

TEST(FindContacts, OnePairThroughTwoImages) {
    const Mat3 edges = Vec3(1.9, 1.15, 1.5).asDiagonal();
    const Packing packing = make_packing(edges, {{0.0, 0.0, 0.0}, {0.9, 0.0, 0.0}}, {1.02, 1.1});
    const std::vector<Contact> contacts = find_contacts(packing);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_EQ(pair_of(contacts[0]), (NearPair{0, 1, Image(-1, 0, 0)}));
    EXPECT_EQ(pair_of(contacts[1]), (NearPair{0, 1, Image(0, 0, 0)}));
    EXPECT_NEAR(contacts[0].overlap, 0.06, 1e-14);
    EXPECT_NEAR(contacts[1].overlap, 0.16, 1e-14);
    EXPECT_NEAR((contacts[0].normal - Vec3::UnitX()).norm(), 0.0, 1e-14);
    EXPECT_NEAR((contacts[1].normal + Vec3::UnitX()).norm(), 0.0, 1e-14);
    EXPECT_EQ(contact_rows(2, contacts).contact_count(0), 2);
}

TEST(FindContacts, AgreesWithBruteForceInTiltedCells) {
    for (const double size_ratio : {1.0, 3.0, 20.0}) {
        for (const double width : {1.35, 3.0}) {
            const auto seed = static_cast<std::uint64_t>(100.0 * width + size_ratio);
            const Mat3 edges = random_edges(width * 1.5 * size_ratio, seed);
            const Packing packing = random_spheres(edges, 300, size_ratio, seed);
            const WrappedSpheres wrapped = wrap_spheres(packing);
            const std::vector<NearPair> expected =
                brute_force_neighbors(wrapped.cell, wrapped.spheres);
            std::vector<NearPair> found;
            for (const Contact& contact : find_contacts(packing)) found.push_back(pair_of(contact));
            EXPECT_GT(expected.size(), 20u);
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(FindContacts, TheSameInAnyImageOfTheParticles) {
    const Mat3 edges = random_edges(6.0, 1);
    const Packing packing = random_spheres(edges, 200, 3.0, 1);
    Packing elsewhere = packing;
    for (int i = 0; i < 200; ++i)
        elsewhere.positions[i] += edges * Vec3(i % 5 - 2, i % 7 - 3, 40 * (i % 3 - 1));
    expect_same_contacts(find_contacts(elsewhere), find_contacts(packing), 1e-12);
}

TEST(FindContacts, TheSameAfterTranslation) {
    const Packing packing = random_spheres(random_edges(6.0, 2), 200, 3.0, 2);
    const Packing shifted =
        moved(packing, [](const Vec3& x) -> Vec3 { return x + Vec3(1.234, -5.678, 0.321); });
    expect_same_contacts(without_images(find_contacts(shifted)),
                         without_images(find_contacts(packing)), 1e-12);
}

TEST(FindContacts, TheSameInOtherEdgesOfTheLattice) {
    const Mat3 edges = random_edges(6.0, 3);
    Mat3 other = edges;
    other.col(1) += 2.0 * edges.col(0);
    other.col(2) += 1.0 * edges.col(1) - 3.0 * edges.col(0);
    const Packing packing = random_spheres(edges, 200, 3.0, 3);
    Packing retold = packing;
    retold.cell = PeriodicCell(other);
    ASSERT_FALSE(retold.cell.is_reduced());
    expect_same_contacts(without_images(find_contacts(retold)),
                         without_images(find_contacts(packing)), 1e-12);
}

TEST(FindContacts, FollowsRelabelling) {
    const Packing packing = random_spheres(random_edges(6.0, 4), 200, 3.0, 4);
    const std::vector<Index> order = shuffled(200, 4);
    std::vector<Contact> retold = find_contacts(relabelled(packing, order));
    for (Contact& contact : retold) {
        contact.first = order[contact.first];
        contact.second = order[contact.second];
        if (contact.first < contact.second) continue;
        std::swap(contact.first, contact.second);
        contact.normal *= -1.0;
    }
    expect_same_contacts(without_images(retold), without_images(find_contacts(packing)), 1e-14);
}

TEST(FindContacts, TheSameBitsForAnyThreadCount) {
    const Packing packing = random_spheres(random_edges(14.0, 5), 3000, 5.0, 5);
    const auto find = [&] { return find_contacts(packing); };
    const std::vector<Contact> reference = run_with_threads(1, find);
    for (const int threads : {2, 3, 8}) {
        const std::vector<Contact> contacts = run_with_threads(threads, find);
        ASSERT_EQ(contacts.size(), reference.size());
        for (std::size_t c = 0; c < contacts.size(); ++c) {
            EXPECT_EQ(pair_of(contacts[c]), pair_of(reference[c]));
            EXPECT_EQ(contacts[c].overlap, reference[c].overlap);
            EXPECT_EQ(contacts[c].force, reference[c].force);
            EXPECT_EQ(contacts[c].normal, reference[c].normal);
        }
    }
}

TEST(FindContacts, RefusesWhatHasNoAnswer) {
    const Packing too_small = make_packing(Mat3::Identity() * 1.9, {{0.0, 0.0, 0.0}}, {2.0});
    EXPECT_THROW(find_contacts(too_small), InputError);
    const Packing coincident =
        make_packing(Mat3::Identity() * 9.0, {{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}, {1.0, 1.0});
    EXPECT_THROW(find_contacts(coincident), InputError);
}

TEST(ContactRows, HoldEachContactAtBothParticles) {
    const Packing packing = random_spheres(random_edges(5.0, 6), 100, 3.0, 6);
    const std::vector<Contact> contacts = find_contacts(packing);
    const ContactRows rows = contact_rows(100, contacts);
    ASSERT_EQ(rows.ends.size(), 2 * contacts.size());
    std::vector<int> seen(contacts.size(), 0);
    for (Index i = 0; i < 100; ++i) {
        for (const ContactEnd end : rows.row(i)) {
            EXPECT_EQ(end.particle(contacts), i);
            EXPECT_EQ(end.sign(), end.is_second() ? -1.0 : 1.0);
            seen[end.contact()] += end.is_second() ? 10 : 1;
        }
    }
    EXPECT_THAT(seen, testing::Each(11));
}

}  // namespace
}  // namespace jam
