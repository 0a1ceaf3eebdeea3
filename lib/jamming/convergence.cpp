// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/convergence.h"

#include "analysis/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {

namespace {

/// Largest minus smallest within the window; NaN while the samples do not yet span it.
template <typename Quantity>
double change_within_window(const JamState& state, const StopSettings& stop, Quantity quantity) {
    const auto& samples = state.samples;
    if (samples.empty() || samples.front().step > state.step - stop.window)
        return std::numeric_limits<double>::quiet_NaN();
    const auto [low, high] = std::minmax_element(
        samples.begin(), samples.end(),
        [&](const Sample& a, const Sample& b) { return quantity(a) < quantity(b); });
    return quantity(*high) - quantity(*low);
}

/// Negative curvature that counts as none, in applied pressures times the backbone's mean diameter.
constexpr double tolerated_instability = 5e-3;

/// Particles of a backbone beyond which a factorization takes minutes and gigabytes.
constexpr Count largest_tested_backbone = 60'000;

Criterion criterion(const char* name, double value, double tolerance) {
    return {name, value, tolerance, value <= tolerance};
}

double mean_diameter_of_backbone(const Packing& packing, const Rattlers& rattlers) {
    double sum = 0.0;
    for (std::size_t i = 0; i < packing.diameters.size(); ++i)
        if (rattlers.is_rattler[i] == 0) sum += packing.diameters[i];
    return sum / static_cast<double>(rattlers.backbone_count());
}

/// -lambda, lambda the smallest eigenvalue of the Hessian of the network's backbone, over the mean
/// pressure and the mean diameter of the spheres that bear it: what a contact's force does to a
/// sphere that is about to buckle, however small the rattlers between are.
double instability(const Packing& packing, const ForceNetwork& network, double pressure) {
    const EnthalpyHessian hessian =
        enthalpy_hessian(packing, network, network.rattlers.is_rattler, pressure);
    const double scale = pressure * mean_diameter_of_backbone(packing, network.rattlers);
    return -find_stability(hessian).smallest_eigenvalue / scale;
}

/// Three contacts hold a particle only in their own plane: at rest it carries next to nothing, and
/// its curvature is round-off. So these are left out, unless what remains gives way: something may
/// lean on one that is slow to buckle, and stands while that does.
double instability(const Measurement& measurement, const ProtocolSettings& protocol) {
    const Packing& packing = measurement.packing;
    const double pressure = protocol.pressure.trace() / 3.0;
    const double held =
        instability(packing, find_force_network(packing, contacts_that_hold), pressure);
    if (held <= tolerated_instability) return held;
    return std::min(held, instability(packing, measurement.network, pressure));
}

/// A relaxation has no motion in time: it has arrived where forces and stress balance, and what it
/// has come to must be able to stand. Stability is asked for last, since it costs most.
Verdict judge_at_rest(const Measurement& measurement, const Scene& scene, bool ask_stability) {
    const PackingStatistics& now = measurement.statistics;
    Verdict verdict;
    verdict.criteria = {
        criterion("pressure", pressure_error(now.pressure, scene.protocol), scene.stop.pressure),
        criterion("cundall", now.cundall, scene.stop.cundall)};
    if (!scene.stop.stability) return verdict;
    verdict.criteria.push_back(
        criterion("missing_contacts", static_cast<double>(-now.excess_contact_count()), 0.0));
    const bool testable = scene.protocol.free_cell == FreeCell::all &&
                          measurement.network.rattlers.backbone_count() <= largest_tested_backbone;
    if (!testable) return verdict;
    const bool asked = ask_stability && verdict.converged();
    verdict.criteria.push_back(criterion(
        "instability",
        asked ? instability(measurement, scene.protocol) : std::numeric_limits<double>::quiet_NaN(),
        tolerated_instability));
    return verdict;
}

}  // namespace

Measurement measure(const JamState& state, const Scene& scene) {
    Measurement measurement;
    measurement.packing = to_packing(state, scene);
    measurement.network = find_force_network(measurement.packing);
    measurement.statistics = packing_statistics(measurement.packing, measurement.network);
    return measurement;
}

Count excess_contact_count_of_held(const Packing& packing) {
    const ForceNetwork held = find_force_network(packing, contacts_that_hold);
    return packing_statistics(packing, held).excess_contact_count();
}

void take_sample(const Measurement& measurement, const StopSettings& stop, JamState& state) {
    auto& samples = state.samples;
    samples.push_back(
        {state.step, measurement.statistics.volume_fraction, measurement.statistics.coordination});
    // The oldest sample kept is the last one that lies a whole window back.
    while (samples.size() > 1 && samples[1].step <= state.step - stop.window) samples.pop_front();
}

double pressure_error(const Mat3& internal, const ProtocolSettings& protocol) {
    Mat3 difference = internal - protocol.pressure;
    if (protocol.free_cell == FreeCell::isotropic)
        difference = Mat3::Identity() * (difference.trace() / 3.0);
    else if (protocol.free_cell == FreeCell::orthogonal)
        difference = Mat3(difference.diagonal().asDiagonal());
    return difference.cwiseAbs().maxCoeff() / (protocol.pressure.trace() / 3.0);
}

Verdict judge(const Measurement& measurement, const JamState& state, const Scene& scene,
              bool ask_stability) {
    const PackingStatistics& now = measurement.statistics;
    const StopSettings& stop = scene.stop;
    if (scene.protocol.kind == ProtocolKind::quasistatic)
        return judge_at_rest(measurement, scene, ask_stability);
    Verdict verdict;
    verdict.criteria = {
        criterion("pressure", pressure_error(now.pressure, scene.protocol), stop.pressure),
        criterion("cundall", now.cundall, stop.cundall),
        criterion("kinetic_energy", now.kinetic_energy_per_particle, stop.kinetic_energy),
        criterion(
            "volume_fraction_change",
            change_within_window(state, stop, [](const Sample& s) { return s.volume_fraction; }),
            stop.volume_fraction_change),
        criterion("coordination_change",
                  change_within_window(state, stop, [](const Sample& s) { return s.coordination; }),
                  stop.coordination_change)};
    return verdict;
}

}  // namespace jam
