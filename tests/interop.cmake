# SPDX-License-Identifier: BSD-3-Clause
# Other programs read what we write, and their values are compared with LAMMPS' own file:
#     ctest --preset release --label-regex interop
# A program that is not installed is reported as skipped. Debian's Python packages are found by
# Debian's interpreter only, whatever else is first on the PATH.
find_program(WIDEJAM_DEBIAN_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT WIDEJAM_DEBIAN_PYTHON)
    message(STATUS "No /usr/bin/python3: tests against other programs are left out")
    return()
endif()

add_executable(write_files interop/write_files.cpp)
target_link_libraries(write_files PRIVATE widejam widejam_build_settings)

set(dump ${PROJECT_SOURCE_DIR}/data/packings/lammps_lambda5_alpha0.6_p5e-3.dump)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/interop)
add_test(NAME interop.write_files COMMAND write_files ${dump} ${folder})
set_tests_properties(interop.write_files PROPERTIES LABELS interop FIXTURES_SETUP interop_files)

foreach(name h5py mdanalysis vtk lammps recipe)
    add_test(NAME interop.${name} COMMAND ${WIDEJAM_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/interop/${name}_test.py
        ${dump} ${folder} ${PROJECT_SOURCE_DIR}/docs/file-format.md)
    set_tests_properties(interop.${name} PROPERTIES
        LABELS interop FIXTURES_REQUIRED interop_files SKIP_RETURN_CODE 77 TIMEOUT 120)
endforeach()
