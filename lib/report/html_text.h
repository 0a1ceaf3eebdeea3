// SPDX-License-Identifier: BSD-3-Clause
// Pieces of an HTML page.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jam::html {

/// Text with the characters that HTML reads as its own written out.
std::string escaped(std::string_view text);

/// Escaped text with ^{...} raised and _{...} lowered.
std::string caption(std::string_view text);

/// "data:image/png;base64,..."
std::string png_data_uri(std::span<const std::uint8_t> png);

/// A drawing by gnuplot made ready to stand inside a page: only the svg element, its size given by
/// the page, and every name in it begun with `prefix`, so that several drawings do not mix up
/// theirs.
std::string inlined_svg(std::string_view svg, std::string_view prefix);

/// Rows of cells; cells are HTML already.
struct TableText {
    std::vector<std::string> head;  ///< may be empty
    std::vector<std::vector<std::string>> rows;
};
std::string table(const TableText& content, std::string_view style_class);

/// A whole page: one file that needs no other.
std::string page(std::string_view title, std::string_view body);

}  // namespace jam::html
