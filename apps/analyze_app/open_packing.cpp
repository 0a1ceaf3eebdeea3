// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/open_packing.h"

#include "core/check.h"
#include "packing/packing_io.h"

#include <algorithm>
#include <filesystem>

namespace jam::apps {

Packing open_packing(const std::string& path) {
    try {
        return read_packing(path);
    } catch (const FileError& error) {
        throw InputError(error.what());
    }
}

std::vector<std::string> packings_at(const std::string& path) {
    namespace fs = std::filesystem;
    if (!fs::is_directory(path)) return {path};
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
        const std::string ending = entry.path().extension();
        const bool is_packing = ending == ".h5" || ending == ".dump";
        if (!entry.is_regular_file() || !is_packing) continue;
        if (entry.path().filename() != "checkpoint.h5") paths.push_back(entry.path());
    }
    require(!paths.empty(), "{}: this folder holds no packing; give one with files .h5 or .dump",
            path);
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace jam::apps
