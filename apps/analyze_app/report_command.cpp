// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/report_command.h"

#include "analyze_app/open_packing.h"
#include "analyze_app/stage_line.h"
#include "core/check.h"
#include "jamming/scene_file.h"
#include "report/run_history.h"
#include "shared/drawing_words.h"
#include "shared/program.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace jam::apps {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const std::vector<std::string>& named) {
    std::vector<fs::path> files;
    for (const std::string& name : named)
        for (const std::string& file : packings_at(name)) files.emplace_back(file);
    return files;
}

/// A run's packing is called by its folder, any other by its file.
std::string name_of_packing(const fs::path& file) {
    if (file.filename() != "packing.h5") return file.filename().string();
    return fs::absolute(file).parent_path().filename().string();
}

/// What the scene in the packing says of its sizes; nothing if there is none, or if it began with
/// another packing.
std::optional<SizeDistribution> sizes_of(const Packing& packing) {
    if (packing.provenance.scene.empty()) return std::nullopt;
    try {
        const Scene scene = parse_scene(packing.provenance.scene, "scene.toml");
        if (!scene.start.packing.empty()) return std::nullopt;
        return scene.sizes.distribution;
    } catch (const InputError&) {  // such as a table that is not at hand here
        return std::nullopt;
    }
}

Table history_beside(const fs::path& packing) {
    const fs::path record = packing.parent_path() / "record.jsonl";
    return packing.filename() == "packing.h5" && fs::exists(record) ? read_run_history(record)
                                                                    : Table{};
}

WrittenReport report_of_one(const fs::path& file, const ReportOptions& options) {
    const StageLine stage;
    ReportSettings settings = options.settings;
    settings.on_stage = [&stage](std::string_view words) { stage.show(words); };
    stage.show("reading " + file.string());
    const Packing packing = open_packing(file);
    return naming(file, [&] {
        return write_packing_report(packing, name_of_packing(file), sizes_of(packing),
                                    history_beside(file), options.output, settings);
    });
}

WrittenReport report_of_many(const std::vector<fs::path>& files, const ReportOptions& options) {
    PackingCollection collection(options.settings);
    for (std::size_t i = 0; i < files.size(); ++i) {
        fmt::print(stderr, "{}/{} {}\n", i + 1, files.size(), files[i].string());
        const Packing packing = open_packing(files[i]);
        naming(files[i],
               [&] { collection.add(packing, name_of_packing(files[i]), sizes_of(packing)); });
    }
    return collection.write(options.output);
}

}  // namespace

CLI::App* add_report_command(CLI::App& program, ReportOptions& options) {
    CLI::App* command =
        program.add_subcommand("report", "Everything about one packing or many, as a page");
    command
        ->add_option("packings", options.packings,
                     "packings, or folders with packings (.h5, .dump)")
        ->required();
    command->add_option("-o,--output", options.output, "folder for report.html and its figures")
        ->capture_default_str();
    command
        ->add_option("--rattler-threshold", options.settings.rattler_threshold,
                     "a particle with fewer contacts is a rattler")
        ->capture_default_str();
    command->add_option("--samples", options.settings.samples, "rays a pixel of the picture")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    return command;
}

int write_report(const ReportOptions& options) {
    const std::vector<fs::path> files = files_of(options.packings);
    const WrittenReport report =
        files.size() == 1 ? report_of_one(files.front(), options) : report_of_many(files, options);
    tell_of_drawing(report.drawing);
    fmt::print("{}\n", report.page.string());
    return exit_good;
}

}  // namespace jam::apps
