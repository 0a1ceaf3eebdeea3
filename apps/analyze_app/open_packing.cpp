// SPDX-License-Identifier: BSD-3-Clause
#include "analyze_app/open_packing.h"

#include "core/check.h"
#include "packing/lammps_dump.h"
#include "packing/packing_file.h"

#include <filesystem>

namespace jam::apps {

Packing open_packing(const std::string& path) {
    try {
        const bool ours = std::filesystem::path(path).extension() == ".h5";
        return ours ? load_packing(path) : read_lammps_dump(path);
    } catch (const FileError& error) {
        throw InputError(error.what());
    }
}

}  // namespace jam::apps
