#!/usr/bin/env bash
# Runs clang-tidy with the repository's .clang-tidy over host/ and tests/; any finding fails. Arguments are regular expressions of files
# to check instead of all: scripts/lint.sh host/scene
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake --preset release -DPENCIL_TESTS=ON -DPENCIL_WERROR=ON >/dev/null
if (($# == 0)); then
    set -- "$PWD/(host|tests)/"
fi
run-clang-tidy -p build/release -quiet -j "$(nproc)" "$@"
