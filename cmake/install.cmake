# SPDX-License-Identifier: BSD-3-Clause
# `cmake --install` and find_package(widejam); the examples in docs/examples/library use both, as tests.
include(CMakePackageConfigHelpers)
set(widejam_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/widejam)

install(TARGETS widejam EXPORT widejam_targets)
install(TARGETS jam_app analyze_app)
install(DIRECTORY lib/ ${PROJECT_BINARY_DIR}/generated/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/widejam
    FILES_MATCHING PATTERN "*.h")
install(EXPORT widejam_targets NAMESPACE widejam:: DESTINATION ${widejam_config_dir})

configure_package_config_file(cmake/widejam-config.cmake.in ${PROJECT_BINARY_DIR}/widejam-config.cmake
    INSTALL_DESTINATION ${widejam_config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/widejam-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/widejam-config.cmake ${PROJECT_BINARY_DIR}/widejam-config-version.cmake
    DESTINATION ${widejam_config_dir})
