#!/usr/bin/env python3
"""Renders the gallery with default options and writes its images and the table between the markers of README.md.

The measured error is that against path tracing, without the noise of the path tracing: the reference is traced in two independent halves
A and B, and (x - A)(x - B) is (x - truth)^2 in the mean. The divisor of relMSE is half of the render's
and half of the reference's: noise of the reference alone would weigh what it makes dark, and the render alone what it misses.

scripts/gallery.py --width 384 --spp 1024"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import tempfile

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = "docs/images/gallery"
BEGIN, END = "<!-- begin: scripts/gallery.sh -->", "<!-- end: scripts/gallery.sh -->"
# Name, and how many times --spp its reference takes: paths seldom find the light behind a door.
SCENES = (("cornell-box", 1), ("colonnade", 1), ("door-ajar", 8), ("thin-walls", 1), ("two-rooms", 1))
# Stages of --stats that are no rendering.
APART = ("load scene", "open device", "kernel build", "write images")
# The standard error of a measured relMSE is at most so many times the noise of the reference over sqrt(pixels): 3.2 and 1.7 in two rooms
# and door ajar.
DOUBT = 4
# relMSE of half a reference beyond which it does not judge.
NOISY = 0.01


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, text=True).stdout


class Gallery:
    def __init__(self, options, folder):
        self.program, self.width, self.spp = options.program.resolve(), options.width, options.spp
        self.references, self.folder = options.references, folder

    def size(self, scene):
        """WxH in the scene's own shape."""
        film = re.search(r"^film +(\d+)x(\d+)", run(self.program, "info", scene), re.MULTILINE)
        return f"{self.width}x{round(self.width * int(film[2]) / int(film[1]))}"

    def reference(self, name, spp, seed, size):
        """Half of a reference, traced unless it lies there already."""
        image = self.references / f"{name}-{size}-{spp}-{seed}.exr"
        if not image.exists():
            print(f"tracing {image}", flush=True)
            run(self.program, "reference", ROOT / f"scenes/{name}.xml", "-o", image, "--resolution", size, "--spp", spp, "--seed", seed,
                "--aov", "none", "--quiet")
        return image

    def average(self, *command):
        """Mean over pixels and channels of what oiiotool leaves."""
        text = run("oiiotool", *command, "--printstats")
        averages = re.search(r"Stats Avg: ([^(\n]*)", text)[1].split()
        return sum(float(value) for value in averages) / len(averages)

    def measured(self, render, name, spp, size):
        """relMSE of the render x without the noise of the reference, from its halves a and b: the mean of (x - a)(x - b) / (d + 0.01 M^2),
        d = (x^2 + m^2) / 2, m = (a + b) / 2, M the mean of m. None where the reference is too noisy to tell:
        noise in the divisor is a bias, or the result is less than twice its standard error."""
        a, b = (self.reference(name, max(spp // 2, 1), seed, size) for seed in (1001, 1002))
        mean = self.folder / "mean.exr"
        run("oiiotool", a, b, "--add", "--mulc", "0.5", "-d", "float", "-o", mean)
        floor = 0.01 * self.average(mean) ** 2
        x = (render, "--ch", "R,G,B")
        scaled = (mean, mean, "--mul", *x, *x, "--mul", "--add", "--mulc", "0.5", "--addc", floor, "--div")
        error = self.average(*x, a, "--sub", *x, b, "--sub", "--mul", *scaled)
        noise = self.average(a, b, "--sub", "--mulc", "0.5", a, b, "--sub", "--mulc", "0.5", "--mul", *scaled)
        doubt = DOUBT * noise / math.sqrt(math.prod(int(side) for side in size.split("x")))
        print(f"{name}: relMSE {error:.3g}, standard error {doubt:.2g}, noise of the reference {noise:.2g}", flush=True)
        return error if error > 2 * doubt and noise < NOISY else None

    def row(self, name, effort):
        scene, base = ROOT / f"scenes/{name}.xml", self.folder / name
        size = self.size(scene)
        run(self.program, "render", scene, "-o", f"{base}.exr", "-o", f"{base}.png", "--stats", f"{base}.json", "--resolution", size,
            "--quiet")
        stats = json.loads(pathlib.Path(f"{base}.json").read_text())
        Image.open(f"{base}.png").convert("RGB").save(ROOT / IMAGES / f"{name}.jpg", quality=85, optimize=True)
        apart = sum(stage["wall_seconds"] for stage in stats["stages"] if stage["name"] in APART)
        return {"name": name, "size": size, "triangles": stats["triangles"], "device": stats["device"],
                "seconds": stats["total_wall_seconds"] - apart, "estimated": stats["estimated_relmse"],
                "measured": self.measured(f"{base}.exr", name, effort * self.spp, size)}


def percent(rel_mse):
    return "-" if rel_mse is None else f"{100 * math.sqrt(rel_mse):.1f} %"


def table(rows, options):
    def line(title, cell):
        return "| " + " | ".join([title, *(cell(row) for row in rows)]) + " |"

    device = rows[0]["device"]
    units = f", {device['compute_units']} cores" if device["is_cpu"] else ""
    return "\n".join([
        line("", lambda row: f"[{row['name']}](scenes/{row['name']}.xml)"), "|---" * (len(rows) + 1) + "|",
        line("", lambda row: f'<img src="{IMAGES}/{row["name"]}.jpg" width="150" alt="{row["name"]}">'),
        line("triangles", lambda row: f"{row['triangles']:,}".replace(",", " ")),
        line("pixels", lambda row: row["size"].replace("x", " x ")),
        line("time", lambda row: f"{row['seconds']:.{1 if row['seconds'] < 10 else 0}f} s"), line("estimated error", lambda row: percent(row["estimated"])),
        line("measured error", lambda row: percent(row["measured"])), "",
        f"{device['name']} ({device['platform']}){units}; `scripts/gallery.sh --width {options.width} --spp {options.spp}`"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--width", type=int, default=384, help="of the images [pixels]")
    parser.add_argument("--spp", type=int, default=1024, help="paths per pixel of a reference; difficult scenes take several times as many")
    parser.add_argument("--references", type=pathlib.Path, default=ROOT / "out/gallery", help="folder where references are kept and found")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/pencil")
    options = parser.parse_args()
    options.references.mkdir(parents=True, exist_ok=True)
    (ROOT / IMAGES).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        gallery = Gallery(options, pathlib.Path(folder))
        rows = [gallery.row(name, effort) for name, effort in SCENES]
    readme = ROOT / "README.md"
    before, rest = readme.read_text().split(BEGIN)
    readme.write_text(f"{before}{BEGIN}\n{table(rows, options)}\n{END}{rest.split(END)[1]}")


if __name__ == "__main__":
    main()
