#!/usr/bin/env bash
# Runs clang-tidy with the repository's .clang-tidy over host/ and tests/; any finding fails. Arguments are regular expressions of files
# to check instead of all: scripts/lint.sh host/scene
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# clang does not read the headers that GCC has precompiled, and files are checked one by one, not in units of several.
cmake --preset release -B build/lint -DPENCIL_TESTS=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_UNITY_BUILD=OFF >/dev/null
if (($# == 0)); then
    set -- "$PWD/(host|tests)/"
fi
run-clang-tidy -p build/lint -quiet -j "$(nproc)" "$@"
