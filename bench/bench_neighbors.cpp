// SPDX-License-Identifier: BSD-3-Clause
// Cost of a neighbor list against the size ratio for the three methods, and against the number and
// spacing of collections (Monti et al., Figs. 10 and 11), as a table, CSV or JSON.
#include "core/check.h"
#include "core/parallel.h"
#include "neighbor_cost.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace jam::bench {
namespace {

struct Options {
    std::string sweep = "methods";
    std::vector<std::string> methods = {"default", "multi-old", "multi"};
    std::vector<double> size_ratios;
    std::vector<double> alphas = {1.0};
    double most_seconds = 60.0;
    std::string csv;
    std::string json;
};

std::vector<NeighborMethod> methods_named(const std::vector<std::string>& names) {
    std::vector<NeighborMethod> methods;
    for (const NamedNeighborMethod& one : neighbor_methods)
        if (std::ranges::find(names, one.name) != names.end()) methods.push_back(one.method);
    return methods;
}

std::vector<NeighborCost> measure(const Options& options) {
    if (options.sweep == "collections") {
        const auto& wanted = options.size_ratios;
        return sweep_collections(wanted.empty() ? std::vector<double>{10, 20, 50, 100} : wanted,
                                 options.alphas);
    }
    const auto& wanted = options.size_ratios;
    return sweep_methods(
        methods_named(options.methods),
        wanted.empty() ? std::vector<double>{2, 5, 10, 20, 50, 100, 200, 300} : wanted,
        options.most_seconds);
}

std::string as_csv(const std::vector<NeighborCost>& costs) {
    std::string text =
        "method,lambda,particles,collections,spacing,build_ns_per_particle,"
        "force_ns_per_particle\n";
    for (const NeighborCost& cost : costs)
        text += fmt::format("{},{},{},{},{},{:.1f},{:.1f}\n", cost.method, cost.size_ratio,
                            cost.particles, cost.collections, cost.spacing, cost.build_ns,
                            cost.force_ns);
    return text;
}

std::string as_json(const std::vector<NeighborCost>& costs) {
    nlohmann::json rows = nlohmann::json::array();
    for (const NeighborCost& cost : costs)
        rows.push_back({{"method", cost.method},
                        {"lambda", cost.size_ratio},
                        {"alpha", cost.alpha},
                        {"particles", cost.particles},
                        {"collections", cost.collections},
                        {"spacing", cost.spacing},
                        {"build_ns_per_particle", cost.build_ns},
                        {"force_ns_per_particle", cost.force_ns},
                        {"model_ns_per_particle", cost.model_ns}});
    return rows.dump(2) + "\n";
}

void write(const std::string& file, const std::string& text) {
    if (file.empty()) return;
    std::ofstream out(file);
    out << text;
    if (!out.flush()) throw FileError(fmt::format("{}: cannot be written", file));
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app{"Cost of building a neighbor list, ns a particle on one thread."};
    app.add_option("--sweep", options.sweep,
                   "methods: binary, f_S = 0.5, against lambda; collections: power laws")
        ->check(CLI::IsMember({"methods", "collections"}))
        ->capture_default_str();
    app.add_option("--method", options.methods, "which of default, multi-old, multi")
        ->check(CLI::IsMember({"default", "multi-old", "multi"}))
        ->delimiter(',');
    app.add_option("--lambda", options.size_ratios, "size ratios, ascending")->delimiter(',');
    app.add_option("--alpha", options.alphas, "exponents of the power laws")->delimiter(',');
    app.add_option("--seconds", options.most_seconds, "a method stops where a build takes longer")
        ->capture_default_str();
    app.add_option("--csv", options.csv, "file for the table");
    app.add_option("--json", options.json, "file for the table with model and alpha");
    CLI11_PARSE(app, argc, argv);
    const auto costs = run_with_threads(1, [&] { return measure(options); });
    write(options.csv, as_csv(costs));
    write(options.json, as_json(costs));
    if (options.csv.empty() && options.json.empty()) fmt::print("{}", as_csv(costs));
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
