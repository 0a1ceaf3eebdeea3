// SPDX-License-Identifier: BSD-3-Clause
// Packings that the user named.
#pragma once

#include "packing/packing.h"

#include <string>

namespace jam::apps {

/// Reads the packing. A file that is missing or damaged is the user's mistake here: it was named on
/// the command line, and nothing has been done yet. Throws InputError only.
Packing open_packing(const std::string& path);

}  // namespace jam::apps
