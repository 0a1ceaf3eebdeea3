// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/jammed_file.h"

#include "analysis/measured_file.h"

namespace jam {

void save_jammed(const JamResult& result, const std::filesystem::path& path) {
    const Measurement& measured = result.measurement;
    save_measured(measured.packing, measured.network, measured.statistics, path);
}

}  // namespace jam
