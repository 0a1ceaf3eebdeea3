// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/open_packing.h"

#include "core/check.h"
#include "packing/packing_io.h"

namespace jam::apps {

Packing open_packing(const std::string& path) {
    try {
        return read_packing(path);
    } catch (const FileError& error) {
        throw InputError(error.what());
    }
}

}  // namespace jam::apps
