# SPDX-License-Identifier: BSD-3-Clause
# What happens at the ends of what can be asked for (docs/extremes.md): not part of ./check:
#     ctest --preset release --label-regex extremes
file(GLOB widejam_extremes_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/extremes/*.cpp
     ${CMAKE_CURRENT_SOURCE_DIR}/support/*.cpp)
widejam_test_program(widejam_extremes ${widejam_extremes_sources})
target_precompile_headers(widejam_extremes REUSE_FROM widejam_tests)
gtest_discover_tests(widejam_extremes DISCOVERY_TIMEOUT 60 PROPERTIES LABELS extremes TIMEOUT 300)
