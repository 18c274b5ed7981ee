#!/usr/bin/env bash
# One command from a fresh checkout to a picture: installs what is missing, builds, renders the Cornell box into out/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
cmake --preset release -DPENCIL_TESTS=OFF
cmake --build --preset release --target pencil
mkdir -p out
build/release/pencil render scenes/cornell-box.xml -o out/cornell-box.exr -o out/cornell-box.png "$@"
echo "$PWD/out/cornell-box.png"
