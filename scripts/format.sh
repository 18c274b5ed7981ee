#!/usr/bin/env bash
# Formats C++ sources, headers and kernels in place; with --check, only says which ones differ and fails. clang-format reads a kernel
# as C++, which does it justice.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(-i)
if [[ ${1:-} == --check ]]; then
    mode=(--dry-run --Werror)
elif (($# > 0)); then
    echo "usage: scripts/format.sh [--check]" >&2
    exit 2
fi
find host tests kernels -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.cl' \) -print0 | sort -z | xargs -0 clang-format "${mode[@]}"
