#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, and runs all tests; its status is theirs. Arguments go to ctest:
# scripts/test.sh -L unit
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
cmake --preset release -DPENCIL_TESTS=ON -DPENCIL_WERROR=ON
cmake --build --preset release

# A cache of kernels in the build tree: no state of the user's decides a result, and a second run is quick.
export POCL_CACHE_DIR="$PWD/build/release/pocl-cache"
mkdir -p "$POCL_CACHE_DIR"
ctest --preset release --parallel "$(nproc)" "$@"
