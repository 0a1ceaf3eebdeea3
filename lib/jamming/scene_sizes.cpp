// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene_sizes.h"

#include "sizes/size_table.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace jam {

std::span<const SizesKind> sizes_kinds() {
    static const std::vector<SizesKind> kinds = {
        {"power-law",
         "number density ~ D^(alpha - 4) for 1 <= D <= size_ratio",
         {"sizes.alpha", "sizes.size_ratio"},
         {"sizes.beta", "sizes.count", "sizes.draw"}},
        {"binary",
         "small spheres of diameter 1, large ones of diameter size_ratio",
         {"sizes.size_ratio", "sizes.small_fraction", "sizes.large_count"},
         {"sizes.draw"}},
        {"monodisperse", "all diameters 1", {"sizes.count"}, {}},
        {"grain-size-distribution",
         "cumulative volume fraction ((D - 1)/(size_ratio - 1))^eta",
         {"sizes.eta", "sizes.size_ratio"},
         {"sizes.count", "sizes.draw"}},
        {"lognormal",
         "ln D normal about ln sqrt(size_ratio), cut to 1 <= D <= size_ratio",
         {"sizes.sigma"},
         {"sizes.size_ratio", "sizes.count", "sizes.draw"}},
        {"table",
         "diameters, or a cumulative curve, from a CSV file",
         {"sizes.file"},
         {"sizes.weight", "sizes.count", "sizes.draw"}},
    };
    return kinds;
}

const SizesKind* find_sizes_kind(std::string_view name) {
    const auto at = std::ranges::find(sizes_kinds(), name, &SizesKind::name);
    return at == sizes_kinds().end() ? nullptr : &*at;
}

bool SizesKind::takes(std::string_view key) const {
    return key == "sizes.kind" || std::ranges::find(required, key) != required.end() ||
           std::ranges::find(optional, key) != optional.end();
}

static SizeDistribution distribution_of(const SizesDraft& draft) {
    if (draft.kind == "power-law")
        return PowerLaw{*draft.size_ratio, draft.alpha ? *draft.alpha : 4.0 - *draft.beta};
    if (draft.kind == "binary")
        return Binary{*draft.size_ratio, *draft.small_fraction, *draft.large_count};
    if (draft.kind == "grain-size-distribution")
        return GrainSizeDistribution{*draft.size_ratio, *draft.eta};
    if (draft.kind == "lognormal") {
        Lognormal sizes{.sigma = *draft.sigma};
        if (draft.size_ratio) sizes.size_ratio = *draft.size_ratio;
        return sizes;
    }
    if (draft.kind == "table")
        return read_size_table(draft.file, draft.weight.value_or(Weight::volume));
    return Monodisperse{};
}

SizesSettings settings_of(const SizesDraft& draft) {
    return {distribution_of(draft), draft.draw, draft.count, draft.file};
}

namespace {

/// Fills in the keys of one kind.
struct FillDraft {
    SizesDraft& draft;

    void operator()(const PowerLaw& sizes) const {
        draft.alpha = sizes.alpha;
        draft.size_ratio = sizes.size_ratio;
    }
    void operator()(const Binary& sizes) const {
        draft.size_ratio = sizes.size_ratio;
        draft.small_fraction = sizes.small_fraction;
        draft.large_count = sizes.large_count;
    }
    void operator()(const Monodisperse&) const {}
    void operator()(const GrainSizeDistribution& sizes) const {
        draft.eta = sizes.eta;
        draft.size_ratio = sizes.size_ratio;
    }
    void operator()(const Lognormal& sizes) const {
        draft.sigma = sizes.sigma;
        draft.size_ratio = sizes.size_ratio;
    }
    void operator()(const DiameterList&) const {}
    void operator()(const CumulativeCurve& sizes) const { draft.weight = sizes.given; }
};

}  // namespace

SizesDraft draft_of(const SizesSettings& settings) {
    SizesDraft draft;
    draft.kind = kind_name(settings.distribution);
    draft.file = settings.file;
    draft.count = settings.count;
    draft.draw = settings.draw;
    std::visit(FillDraft{draft}, settings.distribution);
    return draft;
}

}  // namespace jam
