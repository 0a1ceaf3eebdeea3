// SPDX-License-Identifier: BSD-3-Clause
#include "core/without_openmp.h"

#include <omp.h>

namespace jam {

WithoutOpenMp::WithoutOpenMp() : levels_before_(omp_get_max_active_levels()) {
    omp_set_max_active_levels(0);
}

WithoutOpenMp::~WithoutOpenMp() {
    omp_set_max_active_levels(levels_before_);
}

}  // namespace jam
