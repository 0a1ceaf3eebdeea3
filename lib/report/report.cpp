// SPDX-License-Identifier: BSD-3-Clause
#include "report/report.h"

#include "core/check.h"
#include "core/whole_file.h"
#include "report/group_figures.h"
#include "report/packing_figures.h"
#include "report/picture.h"
#include "report/png_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace jam {

namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

NamedMeasurements measured(const Packing& packing, const ForceNetwork& network,
                           const std::string& name, const std::optional<SizeDistribution>& sizes) {
    Measurements m = measure(packing, network);
    SizesName sizes_name = sizes ? name_of(*sizes) : name_of(m);
    return {name, std::move(sizes_name), std::move(m)};
}

/// Figures written and drawn, with what gnuplot made of them.
std::vector<DrawnFigure> drawn(std::vector<Figure> figures, const std::filesystem::path& folder,
                               Drawing& drawing) {
    write_figures(figures, folder);
    drawing = draw_figures(figures, folder);
    std::vector<DrawnFigure> result;
    for (Figure& figure : figures) {
        std::string svg = drawing.gnuplot_found ? text_of(folder / (figure.name + ".svg")) : "";
        result.push_back({std::move(figure), std::move(svg)});
    }
    return result;
}

/// An older drawing must not be taken for today's.
void remove_old_drawings(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
    for (const Figure& figure : figures)
        for (const char* ending : {".svg", ".png"}) {
            std::error_code not_there;
            std::filesystem::remove(folder / (figure.name + ending), not_there);
        }
}

WrittenReport write_page(const std::string& page, const std::filesystem::path& folder,
                         Drawing drawing) {
    const std::filesystem::path path = folder / "report.html";
    write_whole_file(path, page);
    return {path, std::move(drawing)};
}

void tell(const ReportSettings& settings, std::string_view stage) {
    if (settings.on_stage) settings.on_stage(stage);
}

}  // namespace

WrittenReport write_packing_report(const Packing& packing, const std::string& name,
                                   const std::optional<SizeDistribution>& sizes,
                                   const Table& history, const std::filesystem::path& folder,
                                   const ReportSettings& settings) {
    tell(settings, "contacts and statistics");
    const ForceNetwork network = find_force_network(packing, settings.rattler_threshold);
    NamedMeasurements all = measured(packing, network, name, sizes);
    if (network.rattlers.backbone_count() <= settings.most_for_elasticity) {
        tell(settings, "stability and stiffness");
        all.measurements.elasticity = find_elasticity(packing, network);
    }
    tell(settings, "figures");
    std::vector<Figure> figures = packing_figures(all.measurements, history);
    remove_old_drawings(figures, folder);
    Drawing drawing;
    const std::vector<DrawnFigure> with_drawings = drawn(std::move(figures), folder, drawing);
    tell(settings, "picture");
    const Bitmap bitmap = render_picture(
        packing, color_by_diameter(packing),
        {settings.picture_width, settings.picture_width * 3 / 4, settings.samples, true, {}});
    write_png(bitmap, folder / "picture.png");
    const PageImage picture{"The packing, spheres colored by diameter.", png_bytes(bitmap)};
    return write_page(packing_page(all, packing.provenance, picture, with_drawings), folder,
                      std::move(drawing));
}

void PackingCollection::add(const Packing& packing, const std::string& name,
                            const std::optional<SizeDistribution>& sizes) {
    const ForceNetwork network = find_force_network(packing, settings_.rattler_threshold);
    packings_.push_back(measured(packing, network, name, sizes));
    const std::string& words = packings_.back().sizes.words;
    if (std::ranges::count(pictures_, words, &PageImage::caption) != 0) return;
    const Bitmap bitmap = render_picture(
        packing, color_by_diameter(packing),
        {settings_.gallery_width, settings_.gallery_width, settings_.samples, false, {}});
    pictures_.push_back({words, png_bytes(bitmap)});
}

WrittenReport PackingCollection::write(const std::filesystem::path& folder) const {
    tell(settings_, "averages and figures");
    const std::vector<PackingGroup> groups = group_packings(packings_);
    std::vector<PageImage> pictures;
    pictures.reserve(groups.size());
    for (const PackingGroup& group : groups)
        pictures.push_back(*std::ranges::find(pictures_, group.sizes.words, &PageImage::caption));
    std::vector<Figure> figures = group_figures(packings_, groups);
    remove_old_drawings(figures, folder);
    Drawing drawing;
    const std::vector<DrawnFigure> with_drawings = drawn(std::move(figures), folder, drawing);
    return write_page(packings_page(packings_, groups, pictures, with_drawings), folder,
                      std::move(drawing));
}

}  // namespace jam
