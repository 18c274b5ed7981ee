#!/usr/bin/env bash
# Regenerates docs/thesis-results.md and docs/images/thesis/: renders, compares and times what chapter 6 of the thesis shows, and draws it.
# Takes some minutes. Arguments: see scripts/thesis/results.py --help; --reference FILE.exr saves the path tracing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
cmake --preset release -DPENCIL_TESTS=ON -DPENCIL_WERROR=ON
cmake --build --preset release --target pencil map_study
/usr/bin/python3 scripts/thesis/results.py "$@" # the Python that scripts/setup.sh installs matplotlib for
