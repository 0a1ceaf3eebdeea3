# SPDX-License-Identifier: BSD-3-Clause
# How our own targets are compiled: target widejam_build_settings, linked privately by each of them.
add_library(widejam_build_settings INTERFACE)
target_compile_features(widejam_build_settings INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

target_compile_options(widejam_build_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow=local -Wconversion)
# Several files are compiled as one: most of the time goes into other libraries' headers, read once for each
# compilation. Names in unnamed namespaces are therefore unique within a folder. CMAKE_UNITY_BUILD=OFF suits
# work on one file.
if(NOT DEFINED CMAKE_UNITY_BUILD)
    set(CMAKE_UNITY_BUILD ON)
endif()
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

# GCC 12 reports its own AVX-512 headers as maybe uninitialised (GCC bug 105593).
target_compile_options(widejam_build_settings INTERFACE -Wno-maybe-uninitialized)
# How wide vectors are passed differs between machines without and with AVX; they are passed within this build alone.
target_compile_options(widejam_build_settings INTERFACE -Wno-psabi)
if(WIDEJAM_WERROR)
    target_compile_options(widejam_build_settings INTERFACE -Werror)
endif()

# The same bits whatever the compiler contracts: docs/determinism.md states what this costs.
target_compile_options(widejam_build_settings INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)

if(WIDEJAM_NATIVE)
    target_compile_options(widejam_build_settings INTERFACE -march=native)
endif()
if(WIDEJAM_SANITIZE)
    target_compile_options(widejam_build_settings INTERFACE -fsanitize=${WIDEJAM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(widejam_build_settings INTERFACE -fsanitize=${WIDEJAM_SANITIZE})
endif()
