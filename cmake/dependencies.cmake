# SPDX-License-Identifier: BSD-3-Clause
# Everything from Debian's packages; scripts/install_dependencies.sh installs them.
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_path(WIDEJAM_RANDOM123_INCLUDE Random123/philox.h REQUIRED)
find_path(WIDEJAM_CLI11_INCLUDE CLI/CLI.hpp REQUIRED)
find_path(WIDEJAM_JSON_INCLUDE nlohmann/json.hpp REQUIRED)
