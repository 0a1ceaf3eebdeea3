// SPDX-License-Identifier: BSD-3-Clause
#include "report/canvas.h"

#include "report/color_map.h"

namespace jam {

Bitmap encoded(const Canvas& canvas) {
    Bitmap image{canvas.width, canvas.height, {}};
    image.bytes.reserve(canvas.pixels.size() * 3);
    for (const Rgb& pixel : canvas.pixels)
        for (const std::uint8_t byte : srgb_bytes(pixel)) image.bytes.push_back(byte);
    return image;
}

}  // namespace jam
