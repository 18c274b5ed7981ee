#!/usr/bin/env bash
# Regenerates docs/options.md from the program's own tables of options. A test says when it is out of date.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake --preset release >/dev/null
cmake --build --preset release --target pencil
build/release/pencil document markdown >docs/options.md
