# SPDX-License-Identifier: BSD-3-Clause
# Tests of the project's own scripts, and of the examples in its documents.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND)
    message(STATUS "No Python 3: scripts and documents are not tested (./check installs it)")
    return()
endif()

foreach(name check_layers check_docs)
    add_test(NAME scripts.${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/scripts/${name}_test.py)
endforeach()
add_test(NAME scripts.layers COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/scripts/check_layers.py)

file(GLOB documents CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.md ${PROJECT_SOURCE_DIR}/docs/*.md)
foreach(document IN LISTS documents)
    get_filename_component(name ${document} NAME_WE)
    add_test(NAME docs.${name} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/scripts/check_docs.py
        ${document} --programs $<TARGET_FILE_DIR:jam_app>)
    set_tests_properties(docs.${name} PROPERTIES TIMEOUT 300)
endforeach()
