# SPDX-License-Identifier: BSD-3-Clause
# What happens at the ends of what can be asked for (docs/extremes.md): not part of ./check:
#     ctest --preset release --label-regex extremes
file(GLOB widejam_extremes_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/extremes/*.cpp
     ${CMAKE_CURRENT_SOURCE_DIR}/support/*.cpp)
add_executable(widejam_extremes ${widejam_extremes_sources})
target_include_directories(widejam_extremes PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_include_directories(widejam_extremes SYSTEM PRIVATE ${WIDEJAM_JSON_INCLUDE})
target_compile_definitions(widejam_extremes PRIVATE
    WIDEJAM_DATA_DIR="${PROJECT_SOURCE_DIR}/data"
    WIDEJAM_JAM_APP="$<TARGET_FILE:jam_app>"
    WIDEJAM_ANALYZE_APP="$<TARGET_FILE:analyze_app>")
target_link_libraries(widejam_extremes PRIVATE widejam widejam_build_settings GTest::gtest GTest::gmock GTest::gtest_main)
set_target_properties(widejam_extremes PROPERTIES UNITY_BUILD OFF)
target_compile_options(widejam_extremes PRIVATE $<$<CONFIG:Release>:-O1> -Wno-uninitialized)
target_precompile_headers(widejam_extremes REUSE_FROM widejam_tests)
add_dependencies(widejam_extremes jam_app analyze_app)
gtest_discover_tests(widejam_extremes DISCOVERY_TIMEOUT 60 PROPERTIES LABELS extremes TIMEOUT 300)
