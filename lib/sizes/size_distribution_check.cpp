// SPDX-License-Identifier: BSD-3-Clause
#include "core/check.h"
#include "sizes/size_distribution.h"

namespace jam {

namespace {

// Rules are written so that a value that is not a number breaks them.
void check_range(std::string_view key, double value, double least, double most,
                 std::string_view remedy) {
    require(value >= least && value <= most, "{} = {}: must be from {} to {}; {}", key, value,
            least, most, remedy);
}

void check_size_ratio(double size_ratio) {
    check_range("sizes.size_ratio", size_ratio, 1.0, max_size_ratio,
                "it is the largest diameter divided by the smallest");
}

void check_kind(const PowerLaw& law) {
    check_size_ratio(law.size_ratio);
    require(
        law.alpha >= min_alpha && law.alpha <= max_alpha,
        "sizes.alpha = {} (sizes.beta = {}): alpha must be from {} to {}, beta = 4 - alpha from "
        "{} to {}; 0.2 to 1 is the range of crushed soils",
        law.alpha, 4.0 - law.alpha, min_alpha, max_alpha, 4.0 - max_alpha, 4.0 - min_alpha);
}

void check_kind(const Binary& binary) {
    check_size_ratio(binary.size_ratio);
    require(binary.small_fraction > 0.0 && binary.small_fraction < 1.0,
            "sizes.small_fraction = {}: must lie between 0 and 1, both excluded; it is the volume "
            "of the small spheres divided by that of all; for one size choose sizes.kind = "
            "\"monodisperse\"",
            binary.small_fraction);
    require(binary.large_count >= 1,
            "sizes.large_count = {}: must be at least 1; give the number of large spheres",
            binary.large_count);
}

void check_kind(const Monodisperse&) {}

void check_kind(const GrainSizeDistribution& grains) {
    check_size_ratio(grains.size_ratio);
    check_range("sizes.eta", grains.eta, min_eta, max_eta,
                "it is the exponent of the cumulative volume fraction in (D - 1)/(size_ratio - 1)");
}

void check_kind(const Lognormal& lognormal) {
    check_range("sizes.sigma", lognormal.sigma, min_sigma, max_sigma,
                "it is the standard deviation of ln D; for equal spheres choose sizes.kind = "
                "\"monodisperse\"");
    check_range("sizes.size_ratio", lognormal.size_ratio, 1.01, max_size_ratio,
                "diameters are cut to it about the median; leave it out for exp(6 sizes.sigma)");
}

void check_kind(const DiameterList& list) {
    require(!list.diameters.empty(),
            "sizes.file: no diameters have been read; give a file with at least one");
}

void check_kind(const CumulativeCurve& curve) {
    require(!curve.diameters.empty(),
            "sizes.file: no points have been read; give a file with at least two");
}

}  // namespace

void check(const SizeDistribution& sizes) {
    std::visit([](const auto& kind) { check_kind(kind); }, sizes);
}

std::string_view kind_name(const SizeDistribution& sizes) {
    constexpr std::string_view names[] = {
        "power-law", "binary", "monodisperse", "grain-size-distribution",
        "lognormal", "table",  "table"};
    static_assert(std::size(names) == std::variant_size_v<SizeDistribution>);
    return names[sizes.index()];
}

}  // namespace jam
