// SPDX-License-Identifier: BSD-3-Clause
// Packings that the user named.
#pragma once

#include "core/check.h"
#include "packing/packing.h"

#include <string>
#include <vector>

namespace jam::apps {

/// What `measure` returns; what it refuses is told with the name of the packing.
template <typename Measure>
auto naming(const std::string& path, Measure&& measure) {
    try {
        return measure();
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
}

/// Reads the packing. A file that is missing or damaged is the user's mistake here: it was named on
/// the command line, and nothing has been done yet. Throws InputError only.
Packing open_packing(const std::string& path);

/// The packing at `path`, or all that are in the folder `path` and those below it, in order of
/// their names: files .h5 (but not checkpoint.h5) and .dump. Throws InputError if there are none.
std::vector<std::string> packings_at(const std::string& path);

}  // namespace jam::apps
