# SPDX-License-Identifier: BSD-3-Clause
# Installs this build into a scratch prefix, moves the prefix, and builds and runs the find_package example
# against it: what is installed must stand alone.
set(prefix ${PROJECT_BINARY_DIR}/install_test)
file(WRITE ${PROJECT_BINARY_DIR}/install_and_move.cmake "
    file(REMOVE_RECURSE ${prefix} ${prefix}_first)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix}_first
        OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(RENAME ${prefix}_first ${prefix})
")
add_test(NAME install.install COMMAND ${CMAKE_COMMAND} -P ${PROJECT_BINARY_DIR}/install_and_move.cmake)
add_test(NAME install.find_package COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${PROJECT_SOURCE_DIR}/docs/examples/find_package ${prefix}_example
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
    --test-command pressed_pair)
set_tests_properties(install.install PROPERTIES FIXTURES_SETUP installed)
set_tests_properties(install.find_package PROPERTIES FIXTURES_REQUIRED installed
    PASS_REGULAR_EXPRESSION "overlap 0.250, force 0.250, image along x -1")
