// SPDX-License-Identifier: BSD-3-Clause
// Where the files that the project brings lie.
#pragma once

#include <string>

namespace jam::test {

/// Packings that LAMMPS made; ends with a slash.
inline const std::string packing_folder = WIDEJAM_DATA_DIR "/packings/";

}  // namespace jam::test
