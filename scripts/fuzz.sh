#!/usr/bin/env bash
# Fuzzes what reads files of others: scripts/fuzz.sh [SECONDS for each of scene, gltf, model, obj, ply; default 60]. Needs clang and its
# sanitizer libraries (Debian: clang libclang-rt-14-dev), which nothing else does. New inputs and crashes are kept in build/fuzz/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=${1:-60}
command -v clang++ >/dev/null || {
    echo "fuzz.sh: clang++ is missing; apt-get install clang libclang-rt-14-dev" >&2
    exit 1
}
cmake --preset fuzz
cmake --build --preset fuzz --target fuzz_scene fuzz_gltf fuzz_model fuzz_obj fuzz_ply
cd build/fuzz
for target in scene gltf model obj ply; do
    mkdir -p "corpus/$target"
done
limits=(-max_total_time="$seconds" -timeout=5 -rss_limit_mb=1024 -malloc_limit_mb=256 -print_final_stats=1)
seeds=../../tests/fuzz
tests/fuzz/fuzz_scene "${limits[@]}" -artifact_prefix=crash-scene- -dict="$seeds/scene.dict" corpus/scene "$seeds/scene" ../../scenes
# OpenImageIO leaves a few bytes behind where libpng jumps out of a damaged picture.
ASAN_OPTIONS=detect_leaks=0 tests/fuzz/fuzz_gltf "${limits[@]}" -artifact_prefix=crash-gltf- corpus/gltf "$seeds/gltf"
tests/fuzz/fuzz_model "${limits[@]}" -artifact_prefix=crash-model- corpus/model "$seeds/model"
tests/fuzz/fuzz_obj "${limits[@]}" -artifact_prefix=crash-obj- corpus/obj ../../scenes/meshes
tests/fuzz/fuzz_ply "${limits[@]}" -artifact_prefix=crash-ply- corpus/ply "$seeds/ply"
