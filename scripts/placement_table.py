#!/usr/bin/env python3
"""Prints the relMSE of every placement of --method line against a reference image, as a markdown table.

scripts/placement_table.py scenes/cornell-box.xml truth.exr --pencils 128 --seeds 8"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

PLACEMENTS = ("random", "lds", "near-surface", "light-rays", "camera-rays", "profile", "lds+near-surface", "lds+camera-rays",
              "near-surface+camera-rays", "lds+near-surface+camera-rays", "light-rays+camera-rays")
PROGRAM = pathlib.Path(__file__).resolve().parent.parent / "build/release/pencil"


def error(options, placement, seed, folder):
    """(relMSE, mean ratio) of one render."""
    image = pathlib.Path(folder) / "image.exr"
    size = subprocess.run([PROGRAM, "compare", options.reference, options.reference, "--json"], check=True, capture_output=True).stdout
    width, height = json.loads(size)["size"]
    subprocess.run([PROGRAM, "render", options.scene, "-o", image, "--quiet", "--aov", "none", "--resolution", f"{width}x{height}",
                    "--method", "line", "--placement", placement, "--weights", options.weights, "--pencils", str(options.pencils), "--seed", str(seed)], check=True)
    output = subprocess.run([PROGRAM, "compare", image, options.reference, "--json"], check=True, capture_output=True).stdout
    beauty = json.loads(output)["layers"][0]
    return beauty["rel_mse"], beauty["mean_ratio"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("reference")
    parser.add_argument("--pencils", type=int, default=128)
    parser.add_argument("--weights", default="dpdf")
    parser.add_argument("--seeds", type=int, default=4, help="at least 2")
    parser.add_argument("--placements", default=",".join(PLACEMENTS), help="separated by commas")
    options = parser.parse_args()
    print("| placement | relMSE (standard deviation) | mean ratio |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for placement in options.placements.split(","):
            errors, ratios = zip(*(error(options, placement, seed, folder) for seed in range(options.seeds)))
            print(f"| {placement} | {statistics.mean(errors):.3f} ({statistics.stdev(errors):.3f}) | {statistics.mean(ratios):.3f} |", flush=True)


if __name__ == "__main__":
    main()
