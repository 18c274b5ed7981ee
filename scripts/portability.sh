#!/usr/bin/env bash
# Renders on every OpenCL runtime that can be had and compares with PoCL of this machine: the table of docs/portability.md.
#   scripts/portability.sh [FOLDER]     what is fetched stays in FOLDER, build/portability by default
# Runtimes: PoCL in its variants; with network Intel's CPU driver (PyPI) and, as root, PoCL and rusticl of Debian 13 (debootstrap);
# oclgrind where it is installed. What cannot be had is left out with a word why.
set -euo pipefail
export PENCIL_TUNED=0 # who has tuned what does not decide
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(realpath -m "${1:-build/portability}")
program=$PWD/build/release/pencil
mkdir -p "$folder"
: >"$folder/runtimes"

# A line for each: name, then a command that `pencil` follows.
add() { printf '%s\t%s\n' "$1" "$2" >>"$folder/runtimes"; }
left_out() { echo "portability.sh: left out: $1" >&2; }

fetch_intel() {
    [[ -e $folder/intel/lib/libintelocl.so ]] && return
    python3 -m venv "$folder/intel" && "$folder/intel/bin/pip" --quiet install intel-opencl-rt intel-cmplr-lib-rt
}

# What is mounted must not be there when somebody removes the folder.
unmount() {
    for library in proc sys dev; do umount --recursive --lazy "$folder/trixie/$library" 2>/dev/null || true; done
}
trap unmount EXIT

# The program and the libraries of its own that Debian 13 lacks.
fetch_debian_13() {
    local root=$folder/trixie library
    if [[ ! -e $root/etc/OpenCL/vendors/rusticl.icd ]]; then
        ((EUID == 0)) && command -v debootstrap >/dev/null || return 1
        debootstrap --variant=minbase --include=ocl-icd-libopencl1,pocl-opencl-icd,mesa-opencl-icd trixie "$root" >"$root.log" || return 1
    fi
    # Drivers count processors there.
    for library in proc sys dev; do
        mountpoint --quiet "$root/$library" && continue
        mount --rbind "/$library" "$root/$library" && mount --make-rslave "$root/$library" || return 1
    done
    mkdir -p "$root/pencil/lib" "$root/pencil/scenes"
    cp "$program" "$root/pencil/"
    cp -r scenes/. "$root/pencil/scenes/"
    ldd "$program" | awk '$3 ~ /^\// {print $3}' | while read -r library; do
        [[ -e $root/pencil/lib/${library##*/} || -e $root$library || -e $root/usr$library || $library == */libc.so.6 ]] || cp "$library" "$root/pencil/lib/"
    done
}

pocl="env PENCIL_DEVICE=Portable"
add "PoCL" "$pocl"
add "PoCL, one thread" "$pocl POCL_MAX_PTHREAD_COUNT=1"
add "PoCL, device basic" "$pocl POCL_DEVICES=basic"
add "PoCL, work-groups of at most 16" "$pocl POCL_MAX_WORK_GROUP_SIZE=16"
add "PoCL, work-group loops" "$pocl POCL_WORK_GROUP_METHOD=loops"
for width in 1 4 8; do add "PoCL, packets of $width" "$pocl PENCIL_WIDTH=$width"; done

if fetch_intel; then
    mkdir -p "$folder/icd-intel"
    echo "$folder/intel/lib/libintelocl.so" >"$folder/icd-intel/intel.icd"
    add "Intel CPU" "env OCL_ICD_VENDORS=$folder/icd-intel LD_LIBRARY_PATH=$folder/intel/lib"
else
    left_out "Intel CPU: PyPI cannot be reached"
fi
if fetch_debian_13; then
    inside="chroot $folder/trixie env LD_LIBRARY_PATH=/pencil/lib HOME=/root"
    add "PoCL of Debian 13" "$inside OCL_ICD_VENDORS=pocl.icd"
    add "rusticl of Debian 13, llvmpipe" "$inside OCL_ICD_VENDORS=rusticl.icd RUSTICL_ENABLE=llvmpipe"
else
    left_out "runtimes of Debian 13: they need root, debootstrap and network"
fi
if command -v oclgrind >/dev/null; then add "oclgrind" "oclgrind --check-api"; else left_out "oclgrind: it is not installed"; fi

python3 scripts/portability_table.py "$folder"
