// SPDX-License-Identifier: BSD-3-Clause
#include "report/png_file.h"

#include "core/check.h"
#include "core/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <png.h>

namespace jam {

namespace {

png_image png_header(int width, int height) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width);
    png.height = static_cast<png_uint_32>(height);
    png.format = PNG_FORMAT_RGB;
    return png;
}

}  // namespace

std::vector<std::uint8_t> png_bytes(const Bitmap& image) {
    png_image png = png_header(image.width, image.height);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<std::uint8_t> bytes(size);
    const int written =
        png_image_write_to_memory(&png, bytes.data(), &size, 0, image.bytes.data(), 0, nullptr);
    if (written == 0) throw FileError(fmt::format("PNG: {}", png.message));
    bytes.resize(size);
    return bytes;
}

void write_png(const Bitmap& image, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = png_bytes(image);
    write_whole_file(path, [&](FileSink& sink) { sink.write(std::as_bytes(std::span(bytes))); });
}

Bitmap read_png(const std::filesystem::path& path) {
    png_image png = png_header(0, 0);
    if (png_image_begin_read_from_file(&png, path.c_str()) == 0)
        throw FileError(fmt::format("{}: {}", path.string(), png.message));
    png.format = PNG_FORMAT_RGB;
    Bitmap image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.bytes.resize(PNG_IMAGE_SIZE(png));
    if (png_image_finish_read(&png, nullptr, image.bytes.data(), 0, nullptr) == 0)
        throw FileError(fmt::format("{}: {}", path.string(), png.message));
    return image;
}

}  // namespace jam
