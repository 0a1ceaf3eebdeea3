// SPDX-License-Identifier: BSD-3-Clause
#include "report/html_text.h"

#include "report/number_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace jam {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::uint8_t> bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

TEST(HtmlText, DataUrisAreBase64) {  // RFC 4648, section 10
    const auto data = [](std::string_view text) {
        return html::png_data_uri(bytes_of(text))
            .substr(std::string("data:image/png;base64,").size());
    };
    EXPECT_EQ(data(""), "");
    EXPECT_EQ(data("f"), "Zg==");
    EXPECT_EQ(data("fo"), "Zm8=");
    EXPECT_EQ(data("foo"), "Zm9v");
    EXPECT_EQ(data("foobar"), "Zm9vYmFy");
    EXPECT_EQ(data("\xff\xfe\xfd"), "//79");
}

TEST(HtmlText, EscapesWhatHtmlReadsAsItsOwn) {
    EXPECT_EQ(html::escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
    EXPECT_THAT(html::page("</title><script>", "body"), Not(HasSubstr("<script>")));
}

TEST(HtmlText, CaptionsRaiseAndLower) {
    EXPECT_EQ(html::caption("h^{−γ} < Z_{nr}"), "h<sup>−γ</sup> &lt; Z<sub>nr</sub>");
}

TEST(HtmlText, DrawingsKeepTheirNamesToThemselves) {
    const std::string svg =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n<svg width=\"640\" height=\"420\"\n viewBox=\"0 "
        "0 640 "
        "420\">\n<defs><circle id='gpDot' r='0.5'/></defs><use xlink:href='#gpDot' "
        "fill='url(#gpFill)'/></svg>\n";
    const std::string inlined = html::inlined_svg(svg, "forces");
    EXPECT_EQ(inlined.find("<svg"), 0u);
    EXPECT_THAT(inlined, HasSubstr("id='forces-gpDot'"));
    EXPECT_THAT(inlined, HasSubstr("xlink:href='#forces-gpDot'"));
    EXPECT_THAT(inlined, HasSubstr("url(#forces-gpFill)"));
    EXPECT_THAT(inlined, HasSubstr("max-width:640px"));
    EXPECT_THAT(inlined, Not(HasSubstr("height=\"420\"")));
    EXPECT_EQ(html::inlined_svg("no drawing", "x"), "");
}

TEST(NumberText, ThousandsApart) {
    EXPECT_EQ(grouped(7), "7");
    EXPECT_EQ(grouped(1234567), "1\u202f234\u202f567");
    EXPECT_EQ(grouped(-1005), "−1\u202f005");
}

TEST(NumberText, ThreeDigits) {
    EXPECT_EQ(short_number(0.0123456), "0.0123");
    EXPECT_EQ(short_number(12345.6), "12346");
    EXPECT_EQ(short_number(4.567e-7), "4.57\u00a0×\u00a010⁻⁷");
    EXPECT_EQ(short_number(-1e-6), "−10⁻⁶");
    EXPECT_EQ(short_number(2e12), "2\u00a0×\u00a010¹²");
    EXPECT_EQ(short_number(0.0), "0");
    EXPECT_EQ(short_number(std::nan("")), "–");
}

TEST(NumberText, ErrorsInTheLastDigit) {
    EXPECT_EQ(with_error(0.73834, 0.00052), "0.7383(5)");
    EXPECT_EQ(with_error(6.012, 0.0243), "6.01(2)");
    EXPECT_EQ(with_error(0.7383, std::nan("")), "0.7383");
    EXPECT_EQ(with_error(std::nan(""), 0.1), "–");
}

}  // namespace
}  // namespace jam
