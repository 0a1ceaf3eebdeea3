# SPDX-License-Identifier: BSD-3-Clause
# Installs this build into a scratch prefix, moves the prefix, and builds and runs the examples of the
# library against it: what is installed must stand alone.
set(prefix ${PROJECT_BINARY_DIR}/install_test)
file(WRITE ${PROJECT_BINARY_DIR}/install_and_move.cmake "
    file(REMOVE_RECURSE ${prefix} ${prefix}_first)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix}_first
        OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(RENAME ${prefix}_first ${prefix})
")
add_test(NAME install.install COMMAND ${CMAKE_COMMAND} -P ${PROJECT_BINARY_DIR}/install_and_move.cmake)
set_tests_properties(install.install PROPERTIES FIXTURES_SETUP installed)

set(examples ${prefix}_examples)
add_test(NAME install.examples COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${PROJECT_SOURCE_DIR}/docs/examples/library ${examples}
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})
set_tests_properties(install.examples PROPERTIES FIXTURES_REQUIRED installed FIXTURES_SETUP examples)

add_test(NAME install.make_packing COMMAND ${examples}/make_packing ${examples}/packing.h5)
set_tests_properties(install.make_packing PROPERTIES FIXTURES_REQUIRED examples FIXTURES_SETUP example_packing
    PASS_REGULAR_EXPRESSION "\njammed\n")
# The mean of a density that falls linearly from 1 to 4 is 2.
add_test(NAME install.own_sizes COMMAND ${examples}/own_sizes)
set_tests_properties(install.own_sizes PROPERTIES FIXTURES_REQUIRED examples
    PASS_REGULAR_EXPRESSION "1000 spheres, mean diameter 2.000, mean volume")
add_test(NAME install.own_statistic COMMAND ${examples}/own_statistic ${examples}/packing.h5)
set_tests_properties(install.own_statistic PROPERTIES FIXTURES_REQUIRED "examples;example_packing"
    PASS_REGULAR_EXPRESSION "principal fabric 0\\.3[0-9]+ 0\\.3[0-9]+ 0\\.3[0-9]+, sum 1\\.0000")
