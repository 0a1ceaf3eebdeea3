// SPDX-License-Identifier: BSD-3-Clause
// The pages of a report: each one file that opens without a network and prints well.
#pragma once

#include "packing/packing.h"
#include "report/figure.h"
#include "report/jamming_verdict.h"
#include "report/packing_groups.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace jam {

/// A figure and what gnuplot made of it; an empty drawing where there was no gnuplot.
struct DrawnFigure {
    Figure figure;
    std::string svg;
};

/// A picture of a packing, as the bytes of a PNG file, and what to say below it.
struct PageImage {
    std::string caption;
    std::vector<std::uint8_t> png;
};

/// One packing: its picture, its numbers, whether it is jammed, and its figures.
std::string packing_page(const NamedMeasurements& packing, const Provenance& provenance,
                         const PageImage& picture, std::span<const DrawnFigure> figures);

/// Many packings: averages by group, figures, and each packing's verdict.
std::string packings_page(std::span<const NamedMeasurements> packings,
                          std::span<const PackingGroup> groups, std::span<const PageImage> pictures,
                          std::span<const DrawnFigure> figures);

}  // namespace jam
