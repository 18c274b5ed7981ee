#!/usr/bin/env bash
# Renders the gallery of README.md: docs/images/gallery/*.jpg and the table beside them. The references it judges by take half an hour or
# more the first time and are kept in out/gallery. Arguments: see scripts/gallery.py --help; --spp 64 --width 96 to try it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
cmake --preset release
cmake --build --preset release --target pencil
/usr/bin/python3 scripts/gallery.py "$@" # the Python that scripts/setup.sh installs PIL for
