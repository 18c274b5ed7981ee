#!/usr/bin/env bash
# Fuzzes what reads files of others: scripts/fuzz.sh [SECONDS for each target; default 60] [TARGET ...; default all of tests/fuzz]. Needs clang
# and its sanitizer libraries (Debian: clang libclang-rt-14-dev), which nothing else does. New inputs and crashes are kept in build/fuzz/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=${1:-60}
targets=("${@:2}")
if ((${#targets[@]} == 0)); then
    for source in tests/fuzz/fuzz_*.cpp; do
        target=${source##*/fuzz_}
        targets+=("${target%.cpp}")
    done
fi
command -v clang++ >/dev/null || {
    echo "fuzz.sh: clang++ is missing; apt-get install clang libclang-rt-14-dev" >&2
    exit 1
}
cmake --preset fuzz
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}"

# What a target begins with, beside tests/fuzz/TARGET.
declare -A more=([scene]=scenes [obj]=scenes/meshes [picture]=scenes/textures [ies]=scenes/lights)
for target in "${targets[@]}"; do
    corpus=build/fuzz/corpus/$target
    mkdir -p "$corpus"
    seeds=()
    for folder in "tests/fuzz/$target" ${more[$target]:-}; do
        [[ -d $folder ]] && seeds+=("$folder")
    done
    limits=(-max_total_time="$seconds" -timeout=5 -rss_limit_mb=1024 -malloc_limit_mb=256 -print_final_stats=1
            -artifact_prefix="build/fuzz/crash-$target-")
    # A small file may hold a large picture, and rightly.
    [[ $target == picture ]] && limits+=(-malloc_limit_mb=2200 -rss_limit_mb=4096)
    [[ -f tests/fuzz/$target.dict ]] && limits+=(-dict="tests/fuzz/$target.dict")
    # OpenImageIO leaves a few bytes behind where libpng jumps out of a damaged picture.
    leaks=1
    [[ $target == gltf || $target == scene || $target == picture ]] && leaks=0
    ASAN_OPTIONS=detect_leaks=$leaks "build/fuzz/tests/fuzz/fuzz_$target" "${limits[@]}" "$corpus" "${seeds[@]}"
done
