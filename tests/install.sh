#!/usr/bin/env bash
# The library as its users meet it: installs the build, builds docs/example against the installed copy alone, and renders with it.
#   tests/install.sh SOURCE BUILD [FLAGS]    flags of the compiler that the build needs, as sanitizers do
set -euo pipefail
source=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/installed" >/dev/null
cp -r "$source/docs/example" "$work/example" # away from the sources: nothing is found by accident
cmake -S "$work/example" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/installed" \
    -DCMAKE_CXX_FLAGS="${3-}" >/dev/null
cmake --build "$work/build"
"$work/build/render_room" "$source/scenes/cornell-box.xml" "$work/image.exr"
test -s "$work/image.exr"
"$work/installed/bin/pencil" --version
test -s "$work/installed/share/man/man1/pencil.1"
