// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/picture_command.h"

#include "analysis/force_network.h"
#include "analyze_app/open_packing.h"
#include "analyze_app/stage_line.h"
#include "core/check.h"
#include "report/png_file.h"
#include "shared/program.h"

#include <charconv>
#include <filesystem>
#include <map>
#include <optional>

namespace jam::apps {

namespace {

/// Reads the whole of `text` as a number.
template <typename Number>
std::optional<Number> number_from(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return number;
}

/// Two numbers with `between` between them.
template <typename Number>
std::optional<std::pair<Number, Number>> pair_from(std::string_view text, char between) {
    const std::size_t middle = text.find(between);
    if (middle == std::string_view::npos) return std::nullopt;
    const auto first = number_from<Number>(text.substr(0, middle));
    const auto second = number_from<Number>(text.substr(middle + 1));
    if (!first || !second) return std::nullopt;
    return std::pair{*first, *second};
}

Slice slice_from(const std::string& text) {
    const std::size_t axis = text.empty() ? std::string::npos : std::string("xyz").find(text[0]);
    const auto position = text.size() > 2 && text[1] == '='
                              ? number_from<double>(std::string_view(text).substr(2))
                              : std::nullopt;
    require(axis != std::string::npos && position,
            "--slice {}: must be x, y or z, =, and a fraction of the cell, such as z=0.5", text);
    return {static_cast<int>(axis), *position};
}

View view_from(const std::string& text) {
    const std::map<std::string, View> named = {
        {"corner", {}}, {"x", {0.0, 0.0}}, {"y", {-90.0, 0.0}}, {"z", {-90.0, 90.0}}};
    if (const auto found = named.find(text); found != named.end()) return found->second;
    const auto angles = pair_from<double>(text, ',');
    require(angles && std::abs(angles->second) <= 90.0,
            "--view {}: must be corner, x, y, z, or AZIMUTH,ELEVATION in degrees, the elevation "
            "within -90..90",
            text);
    return {angles->first, angles->second};
}

PictureSettings settings_from(const PictureOptions& options) {
    const auto size = pair_from<int>(options.size, 'x');
    require(size.has_value(), "--size {}: must be WIDTHxHEIGHT in pixels, such as 1600x1200",
            options.size);
    PictureSettings settings{size->first,
                             size->second,
                             options.samples,
                             !options.without_legend,
                             {view_from(options.view), {}, options.cut, !options.without_cell}};
    for (const std::string& slice : options.slices)
        settings.scene.slices.push_back(slice_from(slice));
    return settings;
}

Appearance appearance_of(const Packing& packing, const PictureOptions& options) {
    if (options.color == "diameter" && !options.without_rattlers) return color_by_diameter(packing);
    ForceNetwork network = find_force_network(packing, options.rattler_threshold);
    Appearance appearance =
        options.color == "diameter"       ? color_by_diameter(packing)
        : options.color == "coordination" ? color_by_coordination(packing, network.contacts)
        : options.color == "force"        ? color_by_force(packing, network.contacts)
                                          : color_by_rattler(network.rattlers.is_rattler);
    if (options.without_rattlers) appearance.hidden = std::move(network.rattlers.is_rattler);
    return appearance;
}

}  // namespace

CLI::App* add_picture_command(CLI::App& program, PictureOptions& options) {
    CLI::App* command = program.add_subcommand("picture", "The packing as one would see it");
    command->add_option("packing", options.packing, "a packing: .h5, or a LAMMPS dump")->required();
    command->add_option("-o,--output", options.output, "the picture, a PNG file")->required();
    command->add_option("--color", options.color, "what a sphere's color tells")
        ->check(CLI::IsMember({"diameter", "coordination", "rattler", "force"}))
        ->capture_default_str();
    command->add_flag("--without-rattlers", options.without_rattlers, "the backbone alone");
    command
        ->add_option("--rattler-threshold", options.rattler_threshold,
                     "a particle with fewer contacts is a rattler")
        ->capture_default_str();
    command->add_option("--slice", options.slices,
                        "cut the cell open, such as z=0.5; may be given several times");
    command->add_flag("--cut", options.cut, "cut spheres at the cell's faces");
    command->add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command
        ->add_option("--view", options.view,
                     "from where: corner, x, y, z, or AZIMUTH,ELEVATION in degrees")
        ->capture_default_str();
    command->add_option("--samples", options.samples, "rays a pixel; 256 for print")
        ->capture_default_str();
    command->add_flag("--without-cell", options.without_cell, "no edges of the cell");
    command->add_flag("--without-legend", options.without_legend, "no color bar");
    return command;
}

int write_picture(const PictureOptions& options) {
    require(std::filesystem::path(options.output).extension() == ".png",
            "--output {}: a picture is a PNG file; its name must end in .png", options.output);
    const PictureSettings settings = settings_from(options);
    const StageLine stage;
    stage.show("reading " + options.packing);
    const Packing packing = open_packing(options.packing);
    const Bitmap bitmap = naming(options.packing, [&] {
        stage.show("colors");
        const Appearance appearance = appearance_of(packing, options);
        stage.show("rays");
        return render_picture(packing, appearance, settings);
    });
    write_png(bitmap, options.output);
    return exit_good;
}

}  // namespace jam::apps
