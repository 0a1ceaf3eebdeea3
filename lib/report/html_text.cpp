// SPDX-License-Identifier: BSD-3-Clause
#include "report/html_text.h"

#include "core/version.h"

#include <fmt/format.h>

#include <regex>

namespace jam::html {

namespace {

constexpr std::string_view style = R"css(
:root { --ink: #1f2630; --quiet: #69717d; --line: #e1e4e9; --faint: #f6f7f9; --good: #14694c; --bad: #a4460f; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0 auto; padding: 4.5rem 2rem 5rem; max-width: 62rem; color: var(--ink); background: #fff;
  font: 1.0625rem/1.6 Charter, "Bitstream Charter", "Sitka Text", Cambria, Georgia, serif; }
.over, th, figcaption, .number, footer, nav, .note, .files { font-family: system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
.over { margin: 0; font-size: .8rem; letter-spacing: .09em; text-transform: uppercase; color: var(--quiet); }
h1 { margin: .35rem 0 .2rem; font-size: 2.4rem; line-height: 1.15; font-weight: 500; overflow-wrap: anywhere; }
h2 { margin: 4rem 0 1rem; font-size: 1.5rem; font-weight: 500; }
p { margin: .6rem 0; max-width: 44rem; }
.lead { font-size: 1.2rem; color: var(--quiet); margin: 0 0 1.6rem; }
.verdict { font-size: 1.3rem; margin: 1.6rem 0; }
.good { color: var(--good); } .bad { color: var(--bad); }
.mark { display: inline-block; width: 1.3em; font-weight: 600; }
.picture { margin: 1rem 0 2rem; } .picture img { display: block; width: 100%; height: auto; }
.numbers { display: grid; grid-template-columns: repeat(4, 1fr); gap: 1.6rem 2rem; margin: 2rem 0; padding: 1.8rem 0;
  border-top: 1px solid var(--line); border-bottom: 1px solid var(--line); }
.number b { display: block; font-size: 2rem; line-height: 1.2; font-weight: 300; font-variant-numeric: tabular-nums; }
.number span { font-size: .85rem; color: var(--quiet); line-height: 1.4; display: block; }
table { border-collapse: collapse; width: 100%; margin: 1rem 0; font-variant-numeric: tabular-nums; font-size: 1rem; }
th { text-align: left; font-weight: 500; font-size: .8rem; color: var(--quiet); }
th, td { padding: .5rem 1.4rem .5rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th:last-child, td:last-child { padding-right: 0; }
table.figures-of td:not(:first-child), table.figures-of th:not(:first-child) { text-align: right; }
figure { margin: 2.6rem 0; break-inside: avoid; }
figure svg { display: block; width: 100%; height: auto; }
figcaption { margin-top: .7rem; font-size: .9rem; line-height: 1.5; color: var(--quiet); max-width: 46rem; }
figcaption b { color: var(--ink); font-weight: 600; }
.files { font-size: .8rem; } .files a { color: var(--quiet); }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: 1.4rem; margin: 1.5rem 0; }
.gallery figure { margin: 0; } .gallery img { display: block; width: 100%; height: auto; }
.gallery figcaption { margin-top: .2rem; text-align: center; font-size: .85rem; }
.note { font-size: .9rem; color: var(--quiet); }
details { margin: 1rem 0; } summary { cursor: pointer; }
sup, sub { line-height: 0; font-size: .75em; }
pre { overflow-x: auto; background: var(--faint); padding: 1rem 1.2rem; font-size: .82rem; line-height: 1.45; }
footer { margin-top: 5rem; padding-top: 1rem; border-top: 1px solid var(--line); font-size: .8rem; color: var(--quiet); }
@media (max-width: 44rem) { body { padding: 2rem 1.1rem; } .numbers { grid-template-columns: repeat(2, 1fr); } h1 { font-size: 1.8rem; } }
@media print { body { max-width: none; padding: 0; font-size: 10.5pt; } h2 { margin-top: 2rem; break-after: avoid; }
  figure { margin: 1.2rem 0; } figure svg { width: auto; max-width: 100%; max-height: 11cm; margin: 0 auto; }
  .picture img { max-height: 13cm; width: auto; margin: 0 auto; } .files { display: none; } @page { margin: 18mm; } }
)css";

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char character : text) switch (character) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += character;
        }
    return result;
}

std::string caption(std::string_view text) {
    const std::string raised =
        std::regex_replace(escaped(text), std::regex("\\^\\{([^}]*)\\}"), "<sup>$1</sup>");
    return std::regex_replace(raised, std::regex("_\\{([^}]*)\\}"), "<sub>$1</sub>");
}

std::string png_data_uri(std::span<const std::uint8_t> png) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:image/png;base64,";
    text.reserve(text.size() + 4 * png.size() / 3 + 4);
    for (std::size_t k = 0; k < png.size(); k += 3) {
        const std::size_t left = std::min<std::size_t>(3, png.size() - k);
        std::uint32_t bits = static_cast<std::uint32_t>(png[k]) << 16;
        if (left > 1) bits |= static_cast<std::uint32_t>(png[k + 1]) << 8;
        if (left > 2) bits |= png[k + 2];
        for (std::size_t d = 0; d < 4; ++d)
            text += d <= left ? digits[(bits >> (18 - 6 * d)) & 63U] : '=';
    }
    return text;
}

std::string inlined_svg(std::string_view svg, std::string_view prefix) {
    const std::size_t begin = svg.find("<svg");
    if (begin == std::string_view::npos) return {};
    std::string text(svg.substr(begin));
    // Drawn at its own size where there is room, so that letters are as large in all figures.
    const std::size_t head_end = text.find('>');
    const std::string head = std::regex_replace(text.substr(0, head_end),
                                                std::regex("\\swidth=\"(\\d+)\" height=\"\\d+\""),
                                                " style=\"max-width:$1px\"");
    text = head + " role=\"img\"" + text.substr(head_end);
    const std::string start = fmt::format("$1{}-", prefix);
    return std::regex_replace(text, std::regex("(\\sid=[\"']|xlink:href=[\"']#|url\\(#)"), start);
}

std::string table(const TableText& content, std::string_view style_class) {
    const auto row_of = [](const std::vector<std::string>& cells, std::string_view tag) {
        std::string row = "<tr>";
        for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, cell);
        return row + "</tr>\n";
    };
    std::string text = fmt::format("<table class=\"{}\">\n", style_class);
    if (!content.head.empty()) text += "<thead>" + row_of(content.head, "th") + "</thead>\n";
    text += "<tbody>\n";
    for (const auto& row : content.rows) text += row_of(row, "td");
    return text + "</tbody></table>\n";
}

std::string page(std::string_view title, std::string_view body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>{}</style>\n</head>\n"
        "<body>\n{}<footer>Made by analyze_app {} (Widejam). Tables, gnuplot scripts and PNGs of "
        "every figure lie beside this page.</footer>\n</body>\n</html>\n",
        escaped(title), style, body, version);
}

}  // namespace jam::html
