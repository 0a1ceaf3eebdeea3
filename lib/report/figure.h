// SPDX-License-Identifier: BSD-3-Clause
// Figures: tables, and the gnuplot script that draws them, kept side by side so that whoever wants
// another look edits the script and draws again.
#pragma once

#include "analysis/table.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace jam {

/// One figure. Its files are NAME.gp (the script), one CSV a table, and, once drawn, NAME.svg and
/// NAME.png.
struct Figure {
    struct Data {
        std::string name;  ///< of the CSV file, without its ending
        Table table;
    };

    std::string name;
    std::string title;    ///< a few words
    std::string caption;  ///< what is to be seen, in sentences
    std::string script;   ///< gnuplot; begins with the figure's own settings, draws to all formats
    std::vector<Data> data;
};

/// Writes tables, scripts and the common style.gp into `folder`, which is made where it is missing.
/// Throws FileError.
void write_figures(std::span<const Figure> figures, const std::filesystem::path& folder);

/// How drawing went. Figures that gnuplot could not draw are in `problems`, each with its words.
struct Drawing {
    bool gnuplot_found = true;
    std::vector<std::string> problems;
};

/// Runs gnuplot on the scripts of `figures` in `folder`. Without gnuplot nothing is drawn.
Drawing draw_figures(std::span<const Figure> figures, const std::filesystem::path& folder);

/// The look that all figures share, as a gnuplot script.
std::string style_script();

/// A gnuplot script line that sets a variable.
std::string script_value(const std::string& name, double value);
std::string script_value(const std::string& name, const std::string& text);

}  // namespace jam
