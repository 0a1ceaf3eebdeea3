#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds Debian's oneTBB with the thread sanitizer into build/instrumented_tbb, for the preset tsan. With the
# packaged library the sanitizer cannot see how tasks wait for each other and calls everything a race.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

prefix=$PWD/build/instrumented_tbb
if [[ -e $prefix/lib/cmake/TBB/TBBConfig.cmake ]]; then
    echo "Already there: $prefix"
    exit 0
fi
if ! grep -qx 'ID=debian' /etc/os-release; then
    echo >&2 "The source is taken from Debian, and this is another system. Build oneTBB with"
    echo >&2 "-DTBB_SANITIZE=thread and install it into $prefix."
    exit 1
fi

# apt-get with a list of sources of its own: the system's stays as it is, and no root is needed.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
mkdir -p lists/partial cache/archives/partial
cat > tbb.sources <<SOURCES
Types: deb-src
URIs: http://deb.debian.org/debian
Suites: $(. /etc/os-release && echo "$VERSION_CODENAME")
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
SOURCES
apt=(apt-get --quiet --quiet -o Dir::Etc::sourcelist="$PWD/tbb.sources" -o Dir::Etc::sourceparts=-
     -o Dir::State::lists="$PWD/lists" -o Dir::Cache="$PWD/cache" -o APT::Sandbox::User=root)
"${apt[@]}" update
"${apt[@]}" source --download-only onetbb
tar xf onetbb_*.orig.tar.*

cmake -S oneTBB-* -B build -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DTBB_SANITIZE=thread -DTBB_STRICT=OFF -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF -DTBBMALLOC_PROXY_BUILD=OFF \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib
cmake --build build
cmake --install build >/dev/null
cp oneTBB-*/cmake/suppressions/tsan.suppressions "$prefix/"
echo "Built: $prefix"
