#!/usr/bin/env bash
# Installs what building, testing and formatting pencil needs on Debian 12. This is the only list of packages; everything else calls
# this script. Does nothing, and needs no network, when all of them are installed.
set -euo pipefail

packages=(
    # Build
    g++ cmake ninja-build git
    # OpenCL: loader, headers, and PoCL as the device that is always there
    ocl-icd-opencl-dev opencl-c-headers opencl-clhpp-headers pocl-opencl-icd clinfo
    # Libraries. OpenImageIO's CMake files name a folder of OpenCV, which only libopencv-core-dev has.
    libopenimageio-dev libimath-dev libopencv-core-dev openimageio-tools
    libembree-dev libtbb-dev libglm-dev libcli11-dev libfmt-dev libspdlog-dev libpugixml-dev libtinygltf-dev zlib1g-dev
    nlohmann-json3-dev
    libkainjow-mustache-dev
    # Tests, benchmarks, format, plots
    libgtest-dev libgmock-dev libbenchmark-dev clang-format clang-tidy
    python3 python3-matplotlib python3-numpy python3-pil
)

missing=()
for package in "${packages[@]}"; do
    if [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
        missing+=("$package")
    fi
done
if ((${#missing[@]} == 0)); then
    exit 0
fi

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        echo "setup.sh: run as root or install sudo; missing packages: ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
echo "setup.sh: installing ${missing[*]}"
"${as_root[@]}" apt-get update --quiet --quiet
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet --quiet --no-install-recommends "${missing[@]}"
