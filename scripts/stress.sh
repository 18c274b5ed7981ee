#!/usr/bin/env bash
# Renews the table of stress cases in docs/stability.md from a run of all of them (minutes).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

table=$(mktemp)
trap 'rm -f "$table"' EXIT
# A case that fails is part of the table.
build/release/pencil stress --all --markdown >"$table" || [ $? -eq 9 ]
python3 - "$table" docs/stability.md <<'END'
import pathlib
import re
import sys

table, page = pathlib.Path(sys.argv[1]).read_text(), pathlib.Path(sys.argv[2])
begin, end = "<!-- stress table -->", "<!-- end of stress table -->"
page.write_text(re.sub(f"{begin}.*{end}", lambda _: f"{begin}\n{table}{end}", page.read_text(), flags=re.S))
END
