// SPDX-License-Identifier: BSD-3-Clause
// PNG files.
#pragma once

#include "report/canvas.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace jam {

/// The image as the bytes of a PNG file.
std::vector<std::uint8_t> png_bytes(const Bitmap& image);

/// Writes the image whole or not at all. Throws FileError.
void write_png(const Bitmap& image, const std::filesystem::path& path);

/// Reads an 8-bit RGB picture back (anything else is converted). Throws FileError.
Bitmap read_png(const std::filesystem::path& path);

}  // namespace jam
