// SPDX-License-Identifier: BSD-3-Clause
// Which numbers may stand in the force loop: error of the pair forces and wrong contacts by
// representation of the positions, down the pressures (docs/accuracy.md, "Precision").
#include "dense_packing.h"
#include "neighbors/verlet_lists.h"
#include "precision.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace jam::bench {
namespace {

constexpr double made_at = 1e-3;  ///< pressure of the dense packings

struct Options {
    std::vector<double> size_ratios = {1, 20, 50};
    std::vector<double> pressures = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
};

DensePacking packing_for(double size_ratio) {
    DensePacking wanted;
    wanted.size_ratio = size_ratio;
    wanted.count = size_ratio > 20.0 ? 50000 : size_ratio > 1.0 ? 37000 : 5000;
    return wanted;
}

NeighborList pairs_of(const PeriodicCell& cell, Particles& particles) {
    const std::vector<double> diameters = diameters_by_id(particles);
    VerletLists lists(diameters, {});
    lists.hierarchy.group(particles);
    find_candidates(lists.hierarchy, cell, {0.0, 0.01}, particles, lists.neighbor_scratch,
                    lists.candidates);
    return lists.candidates;
}

void print_errors(const JamState& state, const NeighborList& pairs, double size_ratio,
                  double pressure) {
    for (const PrecisionError& error :
         precision_errors(state.cell, state.particles, pairs, pressure / made_at))
        fmt::print("{:>6} {:>8.0e}  {:36} {:>9.1e} {:>8} of {}\n", size_ratio, pressure,
                   error.representation, error.force_error, error.wrong_contacts, error.contacts);
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app{"Error of the pair forces by representation of the positions."};
    app.add_option("--lambda", options.size_ratios, "size ratios")->delimiter(',');
    app.add_option("--pressure", options.pressures, "of the network, whose overlaps are scaled")
        ->delimiter(',');
    CLI11_PARSE(app, argc, argv);
    fmt::print(
        "lambda pressure  representation                           error    wrong "
        "contacts\n");
    for (const double size_ratio : options.size_ratios) {
        JamState state = dense_packing(packing_for(size_ratio));
        const NeighborList pairs = pairs_of(state.cell, state.particles);
        for (const double pressure : options.pressures)
            print_errors(state, pairs, size_ratio, pressure);
    }
    return 0;
}

}  // namespace
}  // namespace jam::bench

int main(int argc, char** argv) {
    try {
        return jam::bench::run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
