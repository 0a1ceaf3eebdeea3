# SPDX-License-Identifier: BSD-3-Clause
# `cmake --install` and find_package(widejam).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS widejam widejam_build_settings EXPORT widejam_targets)
install(TARGETS jam_app analyze_app)
install(DIRECTORY lib/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/widejam FILES_MATCHING PATTERN "*.h")
install(EXPORT widejam_targets NAMESPACE widejam:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/widejam)

configure_package_config_file(cmake/widejam-config.cmake.in ${PROJECT_BINARY_DIR}/widejam-config.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/widejam)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/widejam-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/widejam-config.cmake ${PROJECT_BINARY_DIR}/widejam-config-version.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/widejam)
