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

# jam_app handoff: LAMMPS goes on with what we hand over.
add_executable(fixed_cell interop/fixed_cell.cpp support/packings.cpp)
target_include_directories(fixed_cell PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(fixed_cell PRIVATE widejam widejam_build_settings GTest::gtest)
set(handoff ${CMAKE_CURRENT_BINARY_DIR}/handoff)
add_test(NAME interop.handoff_packings COMMAND fixed_cell make ${dump} ${handoff})
set_tests_properties(interop.handoff_packings PROPERTIES LABELS interop FIXTURES_SETUP handoff_packings)
foreach(name forces steps)
    add_test(NAME interop.handoff_${name}
        COMMAND ${WIDEJAM_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/interop/handoff_${name}_test.py
            $<TARGET_FILE:jam_app> $<TARGET_FILE:fixed_cell> ${handoff})
    set_tests_properties(interop.handoff_${name} PROPERTIES
        LABELS interop FIXTURES_REQUIRED handoff_packings SKIP_RETURN_CODE 77 TIMEOUT 600 PROCESSORS 2)
endforeach()
add_test(NAME interop.handoff_jammed
    COMMAND ${WIDEJAM_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/interop/handoff_jammed_test.py
        $<TARGET_FILE:jam_app> $<TARGET_FILE:analyze_app> ${handoff})
set_tests_properties(interop.handoff_jammed PROPERTIES
    LABELS interop FIXTURES_REQUIRED handoff_packings SKIP_RETURN_CODE 77 TIMEOUT 600 PROCESSORS 2)
add_test(NAME interop.handoff_protocol
    COMMAND ${WIDEJAM_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/interop/handoff_protocol_test.py
        $<TARGET_FILE:jam_app> ${handoff})
set_tests_properties(interop.handoff_protocol PROPERTIES
    LABELS interop FIXTURES_REQUIRED handoff_packings SKIP_RETURN_CODE 77 TIMEOUT 600 PROCESSORS 2)

# jam_app sweep on a cluster: Snakemake, and a job array without its scheduler.
add_test(NAME interop.sweep_cluster
    COMMAND ${WIDEJAM_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/interop/sweep_cluster_test.py
        $<TARGET_FILE_DIR:jam_app> ${PROJECT_SOURCE_DIR}/docs/examples/sweep ${CMAKE_CURRENT_BINARY_DIR}/sweep)
set_tests_properties(interop.sweep_cluster PROPERTIES LABELS interop SKIP_RETURN_CODE 77 TIMEOUT 600)
