#!/usr/bin/env python3
"""Checks the house: every library of host/ reaches the headers of the folders below it and no others, and an arrow back up does not compile.

    house.py COMPILER BUILD_FOLDER      BUILD_FOLDER/house/<library>.dirs: include folders of that library, one a line
"""
import pathlib
import subprocess
import sys
import tempfile

# The arrows, written down once more: a folder and those that it uses. CMakeLists.txt must not allow others.
USES = {
    "util": [], "options": ["util"], "image": ["util"], "field": ["image", "options"], "cl": ["util"],
    "scene": ["image"], "scene/meshes": ["scene"], "scene/textures": ["scene"], "scene/mitsuba": ["scene/meshes", "scene/textures"],
    "scene/gltf": ["scene/meshes", "scene/textures"], "scene/models": ["scene/meshes", "scene/textures"],
    "scene/formats": ["scene/mitsuba", "scene/gltf", "scene/models"],
    "pencils": ["scene"], "device": ["cl", "pencils", "options"], "visibility": ["device"], "film": ["visibility"], "certify": ["film"],
    "line/placement": ["visibility"], "line": ["certify", "line/placement"], "surface": ["certify"], "render": ["line", "surface"],
    "reference": ["scene", "options"], "compare": ["image", "options"], "converge": ["render", "reference", "compare"], "measure": ["render", "reference"],
    "stress": ["render", "reference"], "app": ["converge", "measure", "stress", "field", "scene/formats"],
}


def below(folder):
    """The folder itself and all that it may see."""
    seen = {folder}
    for used in USES[folder]:
        seen |= below(used)
    return seen


def include_folders(build, folder):
    """Of the project; system folders are the compiler's own business."""
    lines = (build / "house" / f"pencil_{folder.replace('/', '_')}.dirs").read_text().split("\n")
    return [line for line in lines if "/headers/" in line]


def reachable(directories):
    """Folders of host/ whose headers the include folders hold."""
    found = set()
    for directory in directories:
        for header in pathlib.Path(directory).rglob("*.h"):
            folder = str(header.parent.relative_to(directory))
            if folder in USES:
                found.add(folder)
    return found


def compiles(compiler, directories, header):
    with tempfile.TemporaryDirectory() as work:
        source = pathlib.Path(work) / "arrow.cpp"
        source.write_text(f'#include "{header}"\n')
        command = [compiler, "-std=c++17", "-fsyntax-only", *[f"-I{d}" for d in directories], str(source)]
        return subprocess.run(command, capture_output=True, check=False).returncode == 0


def main():
    compiler, build = sys.argv[1], pathlib.Path(sys.argv[2])
    wrong = []
    for folder in USES:
        directories = include_folders(build, folder)
        extra, missing = reachable(directories) - below(folder), below(folder) - reachable(directories)
        wrong += [f"{folder} sees headers of {other}" for other in sorted(extra)]
        wrong += [f"{folder} does not see headers of {other}" for other in sorted(missing)]
    device = include_folders(build, "device")
    if not compiles(compiler, device, "options/layer.h"):
        wrong.append("device cannot include options/layer.h, which it may")
    if compiles(compiler, device, "film/bounce_series.h"):
        wrong.append("device can include film/bounce_series.h, an arrow back up")
    print("\n".join(wrong) or f"{len(USES)} libraries see what they may, and nothing else")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
