// SPDX-License-Identifier: BSD-3-Clause
#include "report/png_file.h"

#include "core/check.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(PngFile, ComesBackAsItWent) {
    const test::ScratchFolder folder;
    Bitmap image{5, 3, {}};
    for (int k = 0; k < 45; ++k) image.bytes.push_back(static_cast<std::uint8_t>(k * 5));
    write_png(image, folder / "a.png");
    const Bitmap back = read_png(folder / "a.png");
    EXPECT_EQ(back.width, 5);
    EXPECT_EQ(back.height, 3);
    EXPECT_EQ(back.bytes, image.bytes);
}

TEST(PngFile, SaysWhereItCannotWriteOrRead) {
    const test::ScratchFolder folder;
    const Bitmap image{1, 1, {0, 0, 0}};
    EXPECT_THROW(write_png(image, folder / "no such folder/a.png"), FileError);
    EXPECT_THROW(read_png(folder / "nothing.png"), FileError);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace jam
