"""Runs pencil and map_study, remembers their commands, and reads what they write."""
import json
import pathlib
import subprocess

import numpy
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
PENCIL = ROOT / "build/release/pencil"
MAP_STUDY = ROOT / "build/release/tests/map_study"
SCENE = "scenes/cornell-box.xml"
WORK = ROOT / "out/thesis"
# As in the thesis: random centres, 50 light samples, one fixed size of the film.
COMMON = ["--method", "line", "--placement", "random", "--light-samples", "50", "--resolution", "512x512", "--quiet"]


def run(program, *arguments):
    """Standard output of a program of the project; its messages and status end the script."""
    command = [str(program), *map(str, arguments)]
    print("thesis_results:", " ".join(command), flush=True)
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout


def render(name, *arguments, device=None):
    """Renders the Cornell box to WORK/name.exr; returns (file, statistics)."""
    output, stats = WORK / f"{name}.exr", WORK / f"{name}.json"
    chosen = ["--device", device] if device else []
    run(PENCIL, "render", SCENE, "-o", output, "--stats", stats, *COMMON, *arguments, *chosen)
    return output, json.loads(stats.read_text())


def reference(spp):
    """The path traced truth; kept in WORK, because its command line decides it."""
    output = WORK / f"reference-{spp}.exr"
    if not output.exists():
        run(PENCIL, "reference", SCENE, "-o", output, "--spp", spp)
    return output


def compare(image, truth):
    """`pencil compare --json` of two files: (L*a*b* RMS of the beauty, exposure of the display)."""
    result = json.loads(run(PENCIL, "compare", image, truth, "--json"))
    beauty = next(layer for layer in result["layers"] if layer["name"] == "beauty")
    return beauty["lab_rms"], result["exposure"]


def mean_ratios(image, truth):
    """Mean of each layer over the reference's, by layer."""
    return {layer["name"]: layer["mean_ratio"] for layer in json.loads(run(PENCIL, "compare", image, truth, "--json"))["layers"]}


def read_layer(file, layer=""):
    """Linear rgb of a layer of an EXR file as float array [height][width][3]."""
    prefix = layer + "." if layer else ""
    tiff = WORK / "channel.tif"
    channels = []
    for channel in "RGB":
        command = ["oiiotool", str(file), "--ch", prefix + channel, "-d", "float", "-o", str(tiff)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        channels.append(numpy.array(Image.open(tiff), dtype=float))
    return numpy.stack(channels, axis=-1)


def stage(stats, name):
    return next(s for s in stats["stages"] if s["name"] == name)


def least_times(repeats, name, arguments, measure, device=None):
    """Least values of the numbers that `measure` takes from the statistics of equal renders; the first one warms caches up."""
    results = []
    for _ in range(repeats + 1):
        _, stats = render(name, *arguments, device=device)
        results.append(measure(stats))
    return [min(column) for column in zip(*results[1:])], stats
