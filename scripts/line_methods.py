#!/usr/bin/env python3
"""Compares the forms of the line method with light paths: error, mean, orders of bounces, and the front of the Cornell box' short block.

    scripts/line_methods.py build/release/pencil [--forms weights] [--seeds 3] [--reference-time 60] [--keep DIR]

Prints a table of docs/accuracy.md: of --forms weights, or of iteration. Takes about 20 minutes with the defaults."""

import argparse
import json
import os
import re
import subprocess
import tempfile

import numpy
import OpenImageIO

SCENES = ("cornell-box", "two-rooms", "door-ajar")
SCENE_FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes")
SIZE = 192
FORMS = {
    "weights": {"line, dpdf": "--method line", "line, voronoi": "--method line --weights voronoi",
                "line, 512 pencils": "--method line --pencils 512", "hybrid, 16 rays": "--method hybrid --rays 16",
                "hybrid": "--method hybrid", "hybrid, 16 pencils": "--method hybrid --pencils 16"},
    "iteration": {f"{name}, {iterate}": f"--method {flags} --iterate {iterate}"
                  for name, flags in {"line, 1024 pencils": "line --pencils 1024 --map 32", "hybrid, 128 pencils": "hybrid"}.items()
                  for iterate in ("sets", "fixed", "levels")}}
FRONT = (0.70, 0.87, 0.53, 0.71)  # rows and columns of the block's front, as shares of the film
LAST_ORDER = 10


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def red_front(path):
    pixels = OpenImageIO.ImageBuf(path).get_pixels(OpenImageIO.FLOAT)
    rows, columns = pixels.shape[:2]
    top, bottom, left, right = FRONT
    return float(pixels[int(top * rows):int(bottom * rows), int(left * columns):int(right * columns), 0].mean())


def compare(image, reference):
    """relMSE and mean ratio of each layer."""
    table = {}
    for line in run(PENCIL, "compare", image, reference).splitlines():
        fields = line.split()
        if len(fields) > 4 and re.fullmatch(r"beauty|bounce\d+", fields[0]):
            table[fields[0]] = (float(fields[2]), float(fields[3]))
    return table


def truth(name, folder, seconds):
    """Paths of a scene of the project and of its image by light paths, made where it is not there yet."""
    scene, reference = os.path.join(SCENE_FOLDER, name + ".xml"), os.path.join(folder, name + "-truth.exr")
    if not os.path.exists(reference):
        run(PENCIL, "reference", scene, "-o", reference, "--resolution", f"{SIZE}x{SIZE}", "--time", seconds, "--quiet")
    return scene, reference


def measure(scene, flags, seed, folder, reference):
    image, stats = os.path.join(folder, "image.exr"), os.path.join(folder, "stats.json")
    run(PENCIL, "render", scene, "-o", image, "--resolution", f"{SIZE}x{SIZE}", "--seed", str(seed), "--quiet", "--stats", stats,
        *flags.split())
    with open(stats, encoding="utf-8") as file:
        times = json.load(file)
    layers = compare(image, reference)
    orders = [ratio for name, (_, ratio) in layers.items() if name != "beauty" and int(name[6:]) <= LAST_ORDER] or [numpy.nan]
    seconds = times["total_wall_seconds"] - times["kernel_build_seconds"]
    return (*layers["beauty"], min(orders), max(orders), red_front(image) / red_front(reference), seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pencil")
    parser.add_argument("--forms", choices=FORMS, default="weights")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--reference-time", default="60")
    parser.add_argument("--keep")
    options = parser.parse_args()
    global PENCIL
    PENCIL = os.path.abspath(options.pencil)
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or temporary
        os.makedirs(folder, exist_ok=True)
        print("| scene | form | relMSE | mean | orders 2 to 10 | red of the front | seconds |\n|---|---|---|---|---|---|---|")
        for name in SCENES:
            scene, reference = truth(name, folder, options.reference_time)
            for form, flags in FORMS[options.forms].items():
                rows = numpy.array([measure(scene, flags, seed, folder, reference) for seed in range(options.seeds)])
                error, mean, _, _, front, seconds = rows.mean(axis=0)
                front = f"{front:.2f}" if name == "cornell-box" else ""
                orders = "" if numpy.isnan(rows[:, 2]).any() else f"{rows[:, 2].min():.2f} to {rows[:, 3].max():.2f}"
                print(f"| {name} | {form} | {error:.2g} | {mean:.3f} | {orders} | {front} | "
                      f"{seconds:.1f} |", flush=True)


if __name__ == "__main__":
    main()
