#!/usr/bin/env bash
# Says whether two programs make the same images, bit for bit in every layer: for changes that must not change any. Renders every scene
# with both methods at two sizes, by work that no clock decides. Exit status 1 if any image differs.
#   scripts/same_images.sh [--quick] [--except LAYERS] OLD NEW
# OLD, NEW: two `pencil` programs; --quick: one size, less work; --except: layers that may differ or be absent, "error,tail"; "beauty" is
# the image itself, "tail" and "bounce" are those of any order.
set -euo pipefail
export PENCIL_TUNED=0 # who has tuned what does not decide
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() { sed -n '4,6s/^# \{0,1\}//p' "$0"; }

sizes=(96x72 61x47)
surface=(--target-error 0.002)
line=(--method line --pencils 64)
except=
programs=()
while (($# > 0)); do
    case $1 in
        --quick) sizes=(61x47) surface=(--target-error 0.01) line=(--method line --pencils 32) ;;
        --except) except=${2:?"--except needs names of layers"}; shift ;;
        -h | --help) usage; exit 0 ;;
        -*) usage >&2; exit 2 ;;
        *) programs+=("$1") ;;
    esac
    shift
done
if ((${#programs[@]} != 2)); then
    usage >&2
    exit 2
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Channels that must be the same, one a line.
kept_channels() {
    oiiotool --info -v "$1" | sed -n 's/^ *channel list: //p' | tr -d ' ' | tr ',' '\n' | awk -v except="$except" '
        BEGIN { n = split(except, names, ","); for (i = 1; i <= n; ++i) left_out[names[i]] = 1 }
        { layer = $0; if (!sub(/\.[^.]*$/, "", layer)) layer = "beauty"
          kind = layer; sub(/[0-9]+$/, "", kind); if (!(layer in left_out) && !(kind in left_out)) print }'
}

layers_of() { sed 's/^[^.]*$/beauty/; s/\.[^.]*$//' | sort -u; }

# Names of these channels and a hash of their values.
content() {
    local channels
    channels=$(kept_channels "$1" | paste -sd,)
    oiiotool "$1" --ch "$channels" -o "$1.kept.exr"
    echo "$channels $(oiiotool --hash --info -v "$1.kept.exr" | sed -n 's/^ *SHA-1: //p')"
}

# What differs and by how much, in one line, from `compare --json`.
differences() {
    "${programs[1]}" compare --json "$work/new.exr" "$work/old.exr" 2>/dev/null | python3 -c '
import json, sys
result, named = json.load(sys.stdin), sys.argv[1].split(",")
def left_out(name):
    return name in named or name.rstrip("0123456789") in named
def same(layer):
    return layer["rmse"] == 0 and layer["excluded_pixels"] == 0
def text(layer):
    holes = f""", {layer["excluded_pixels"]} pixels not finite""" if layer["excluded_pixels"] else ""
    return f"""{layer["name"]} (RMSE {layer["rmse"] or 0:.2g}{holes})"""
found = [text(layer) for layer in result["layers"] if not left_out(layer["name"]) and not same(layer)]
for program, key in (("new", "only_in_image"), ("old", "only_in_reference")):
    found += [f"{name} (only {program})" for name in result[key] if not left_out(name)]
print(f"""{len(found)} layers: {", ".join(found)}""" if found else "in bits that change no value: signs of zeros, kinds of NaN")' "$except"
}

render() {  # PROGRAM OUTPUT SCENE OPTIONS...
    "$1" render "$3" -o "$2" --quiet "${@:4}" >"$work/log" 2>&1 || { tail -n 2 "$work/log" | paste -sd' '; return 1; }
}

images=0 different=0
check() {  # SCENE OPTIONS...
    local name answer
    name="$(basename "$1" .xml) ${*:2}"
    if ! answer=$(render "${programs[0]}" "$work/old.exr" "$@") || ! answer=$(render "${programs[1]}" "$work/new.exr" "$@"); then
        answer="FAILED   $answer"
    elif [[ $(content "$work/old.exr") == $(content "$work/new.exr") ]]; then
        answer="same     $(kept_channels "$work/new.exr" | layers_of | wc -l) layers"
    else
        answer="DIFFERS  $(differences 2>/dev/null || echo "and cannot be compared")"
    fi
    [[ $answer == same* ]] || different=$((different + 1))
    images=$((images + 1))
    printf '%-58s %s\n' "$name" "$answer"
}

for scene in "$root"/scenes/*.xml; do
    for size in "${sizes[@]}"; do
        check "$scene" --resolution "$size" "${surface[@]}"
        # Line projection knows no light from infinitely far away, and no lens.
        grep -qE 'type="(envmap|constant|sky|sunsky|directional|thinlens|orthographic)"' "$scene" || check "$scene" --resolution "$size" "${line[@]}"
    done
done
if ((different > 0)); then
    echo "$different of $images images differ"
    exit 1
fi
echo "all $images images are the same"
