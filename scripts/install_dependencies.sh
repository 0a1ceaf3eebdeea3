#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages that Widejam needs and that are not there yet; silent if none is missing.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/install_dependencies.sh [--check] [--interop] [--dry-run]
  (nothing)   what building and running takes
  --check     also what ./check takes: formatter, linter, Doxygen, Python
  --interop   also the programs that tests/interop runs: h5py, MDAnalysis, VTK, LAMMPS, Snakemake
  --dry-run   only say what is missing
USAGE
}

core=(g++ cmake ninja-build git libtbb-dev libeigen3-dev libhdf5-dev libgtest-dev libgmock-dev
      libbenchmark-dev libtomlplusplus-dev libcli11-dev libspdlog-dev libfmt-dev nlohmann-json3-dev
      librandom123-dev libboost-dev gnuplot-nox libembree-dev libpng-dev libsuitesparse-dev
      libopenblas0-serial)
check=(clang-format clang-tidy doxygen python3)
interop=(python3-h5py python3-mdanalysis python3-vtk9 lammps snakemake)

wanted=("${core[@]}")
dry_run=no
for argument in "$@"; do
    case "$argument" in
        --check) wanted+=("${check[@]}") ;;
        --interop) wanted+=("${interop[@]}") ;;
        --dry-run) dry_run=yes ;;
        --help | -h) usage; exit 0 ;;
        *) usage >&2; exit 2 ;;
    esac
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    cat >&2 <<MESSAGE
Widejam takes its dependencies from Debian packages, and this system has no apt-get.
Install what corresponds to these packages (any recent Linux has them):
    ${wanted[*]}
then build without this script:
    cmake --preset release && cmake --build --preset release
MESSAGE
    exit 1
fi

installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
    grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

echo "Missing Debian packages: ${missing[*]}"
[[ $dry_run == no ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        printf >&2 'Installing them takes root and there is no sudo here. As root:\n    apt-get install --no-install-recommends %s\n' \
            "${missing[*]}"
        exit 1
    fi
    as_root=(sudo)
    echo "Installing them takes root: sudo may ask for your password."
fi

# The lists first: on a fresh machine they are empty, on an old one they name files long gone. A third-party
# source that fails need not matter, so it is left to the installation to succeed or not.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive DEBCONF_NOWARNINGS=yes apt-get --quiet --quiet -o Dpkg::Use-Pty=0
     -o Acquire::Retries=3 -o DPkg::Lock::Timeout=120)
echo "This takes a minute or two."
"${apt[@]}" update || echo >&2 "apt-get update had trouble; trying to install all the same."
if ! "${apt[@]}" install --yes --no-install-recommends "${missing[@]}" >/dev/null; then
    echo >&2 "apt-get could not install them (its words are above). Remedy that, then run this again."
    exit 1
fi
echo "Installed."
