#!/usr/bin/env bash
# Builds and runs the microbenchmarks: every kernel beside a native loop of the same work. Writes bench.json (google-benchmark's format)
# and bench.md (the table of docs/performance.md) into the output folder.
#   scripts/bench.sh [-o DIR] [--update-docs] [--device D] [options of google-benchmark, such as --benchmark_filter=project]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=out/bench
docs=()
options=()
while (($# > 0)); do
    case $1 in
        -o) out=${2:?"-o needs a folder"}; shift ;;
        --update-docs) docs=(--docs docs/performance.md) ;;
        -h | --help) sed -n '2,4s/^# \{0,1\}//p' "$0"; exit 0 ;;
        *) options+=("$1") ;;
    esac
    shift
done

scripts/setup.sh
cmake --preset release -DPENCIL_TESTS=ON -DPENCIL_BENCH=ON >/dev/null
cmake --build --preset release --target pencil_bench
mkdir -p "$out"

# Kernel and native loop run by turns within a repetition; the table holds medians over repetitions.
build/release/tests/bench/pencil_bench --benchmark_repetitions=9 --benchmark_min_time=0.1 --benchmark_display_aggregates_only=true \
    --benchmark_out="$out/bench.json" --benchmark_out_format=json "${options[@]}"
python3 scripts/bench_table.py "$out/bench.json" -o "$out/bench.md" "${docs[@]}"
echo "$out/bench.json $out/bench.md"
