// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/bins.h"

#include "analysis/table.h"
#include "core/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace jam {
namespace {

using testing::ElementsAre;

TEST(Bins, HoldTheirLowerEdgeAndTheLastItsUpper) {
    const Bins bins = linear_bins(0.0, 3.0, 3);
    EXPECT_THAT(bins.edges, ElementsAre(0.0, 1.0, 2.0, 3.0));
    EXPECT_EQ(bins.bin_of(0.0), 0);
    EXPECT_EQ(bins.bin_of(0.999), 0);
    EXPECT_EQ(bins.bin_of(1.0), 1);
    EXPECT_EQ(bins.bin_of(3.0), 2);
    EXPECT_EQ(bins.bin_of(-1e-9), -1);
    EXPECT_EQ(bins.bin_of(3.001), -1);
    EXPECT_EQ(bins.bin_of(std::numeric_limits<double>::quiet_NaN()), -1);
}

TEST(Bins, LogarithmicStepsAreEqualFactors) {
    const Bins bins = logarithmic_bins(0.01, 100.0, 5);
    ASSERT_EQ(bins.count(), 20);
    for (int b = 0; b < bins.count(); ++b)
        EXPECT_NEAR(bins.edges[b + 1] / bins.edges[b], std::pow(10.0, 0.2), 1e-12);
    EXPECT_EQ(bins.edges.front(), 0.01);
    EXPECT_EQ(bins.edges.back(), 100.0);
}

TEST(Bins, OneSizeHasABinOfItsOwn) {
    const Bins bins = logarithmic_bins(2.0, 2.0, 20);
    EXPECT_EQ(bins.count(), 1);
    EXPECT_EQ(bins.bin_of(2.0), 0);
    EXPECT_GT(bins.width(0), 0.0);
}

TEST(Bins, RefuseWhatHasNoLogarithm) {
    EXPECT_THROW(logarithmic_bins(0.0, 1.0, 10), InputError);
    EXPECT_THROW(logarithmic_bins(2.0, 1.0, 10), InputError);
    EXPECT_THROW(linear_bins(1.0, 1.0, 10), InputError);
}

TEST(Bins, DensityIntegratesToOne) {
    Bins bins;
    bins.edges = {0.0, 1.0, 3.0, 7.0};
    EXPECT_THAT(as_density(bins, {2, 4, 2}), ElementsAre(0.25, 0.25, 0.0625));
    EXPECT_THAT(as_density(bins, {0, 0, 0}), ElementsAre(0.0, 0.0, 0.0));
}

TEST(Table, BecomesCsvWithEveryDigit) {
    const Table table{{{"a", {1.0, 0.1}}, {"b", {2.5e-7, std::nan("")}}}};
    EXPECT_EQ(csv_text(table), "a,b\n1,2.5e-07\n0.1,nan\n");
    EXPECT_EQ(csv_text(Table{{{"a", {}}}}), "a\n");
}

}  // namespace
}  // namespace jam
