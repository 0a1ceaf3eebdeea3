// SPDX-License-Identifier: BSD-3-Clause
#include "support/example_packings.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <bit>

namespace jam::test {

namespace {

Vec3 random_vector(std::uint64_t id, std::uint32_t first_draw) {
    Vec3 vector;
    for (std::uint32_t k = 0; k < 3; ++k)
        vector[k] = uniform(11, RandomStream::tests, id, first_draw + k);
    return vector;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <typename Derived>
bool same_bits(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (!same_bits(a.derived().data()[i], b.derived().data()[i])) return false;
    return true;
}

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same_bits(a[i], b[i])) return false;
    return true;
}

}  // namespace

Packing example_packing(Index size) {
    Packing packing;
    Mat3 h;
    h << 10.0 / 3.0, -0.7, 0.4, 0.0, 4.1, -1.3, 0.0, 0.0, 5.9;
    packing.cell = PeriodicCell(h);
    for (Index i = 0; i < size; ++i) {
        const auto id = static_cast<std::uint64_t>(i);
        packing.positions.push_back(packing.cell.cartesian(random_vector(id, 0)));
        packing.velocities.push_back(1e-3 * (random_vector(id, 3) - Vec3::Constant(0.5)));
        packing.diameters.push_back(1.0 + 4.0 * random_vector(id, 6)[0]);
        packing.ids.push_back((std::int64_t{i} * 7) % size + 1);  // sizes are not multiples of 7
    }
    packing.material = {ContactLaw::hertz, 1.7, 0.3, 2.5};
    packing.step = 123456789012;
    packing.time = 1.0 / 3.0;
    packing.applied_pressure << 1e-6, 2e-8, -3e-8, 2e-8, 1.1e-6, 4e-8, -3e-8, 4e-8, 0.9e-6;
    packing.provenance = {"program 1.2", "program run scene.toml", "[sizes]\nkind = \"Größe\"\n",
                          R"({"converged":true})", 0xfedcba9876543210};
    return packing;
}

void expect_same_bits(const Packing& packing, const Packing& expected) {
    EXPECT_TRUE(same_bits(packing.cell.matrix(), expected.cell.matrix()));
    EXPECT_TRUE(same_bits(packing.positions, expected.positions));
    EXPECT_TRUE(same_bits(packing.velocities, expected.velocities));
    EXPECT_TRUE(same_bits(packing.diameters, expected.diameters));
    EXPECT_EQ(packing.ids, expected.ids);
    EXPECT_EQ(packing.material.law, expected.material.law);
    EXPECT_TRUE(same_bits(packing.material.stiffness, expected.material.stiffness));
    EXPECT_TRUE(same_bits(packing.material.damping, expected.material.damping));
    EXPECT_TRUE(same_bits(packing.material.density, expected.material.density));
    EXPECT_EQ(packing.step, expected.step);
    EXPECT_TRUE(same_bits(packing.time, expected.time));
    EXPECT_TRUE(same_bits(packing.applied_pressure, expected.applied_pressure));
    EXPECT_EQ(packing.provenance.creator, expected.provenance.creator);
    EXPECT_EQ(packing.provenance.command_line, expected.provenance.command_line);
    EXPECT_EQ(packing.provenance.scene, expected.provenance.scene);
    EXPECT_EQ(packing.provenance.verdict, expected.provenance.verdict);
    EXPECT_EQ(packing.provenance.seed, expected.provenance.seed);
}

}  // namespace jam::test
