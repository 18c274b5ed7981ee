#!/usr/bin/env python3
"""portability_table.py FOLDER: runs the runtimes of FOLDER/runtimes (scripts/portability.sh) and prints a table in Markdown.

Each runtime: self-test; small renders by surface pencils and lines with the same seed, whose relMSE to the first runtime's is stated; seconds
of building kernels with an empty and with a filled cache, kernel time relative to the first. Ends with 1 if one fails or differs by more than 1e-5, with lobes 1e-4. oclgrind has the self-test alone.
"""
import json
import os
import re
import shutil
import subprocess
import sys

PROGRAM = "build/release/pencil"
RENDERS = {"surface": ["cornell-box", "--target-error", "1"], "lobes": ["still-life", "--target-error", "1"],
           "line": ["cornell-box", "--method", "line", "--pencils", "16"]}
SIZE, TINY = "64x48", "6x4"
MOST = 1e-5
# Rounding decides where long chains of mirrors go: another vector unit, another chain.
MOST_LOBES = 1e-4


class Runtime:
    def __init__(self, name, command, folder):
        self.name, self.prefix, self.folder = name, command.split(), folder
        self.inside = self.prefix[0] == "chroot"
        self.is_slow = "oclgrind" in name or "llvmpipe" in name
        self.root = self.prefix[1] if self.inside else ""
        self.cache = os.path.join("/tmp" if self.inside else folder, "cache-" + re.sub(r"\W+", "-", name))

    def run(self, *arguments, limit=900):
        program = "/pencil/pencil" if self.inside else os.path.abspath(PROGRAM)
        env = [f"POCL_CACHE_DIR={self.cache}/pocl", f"XDG_CACHE_HOME={self.cache}"]
        at = self.prefix.index("env") + 1 if "env" in self.prefix else 0
        command = self.prefix[:at] + env + self.prefix[at:] if at else ["env", *env, *self.prefix]
        return subprocess.run([*command, program, *arguments], capture_output=True, text=True, timeout=limit)

    def path(self, name):
        """A file as the program sees it, and as we do."""
        inside = f"/tmp/{name}" if self.inside else os.path.join(self.folder, re.sub(r"\W+", "-", self.name) + "-" + name)
        return inside, self.root + inside

    def clear(self):
        shutil.rmtree(self.root + self.cache, ignore_errors=True)
        os.makedirs(self.root + self.cache + "/pocl")

    def render(self, kind):
        """Seconds of building and of kernels, and the image's file; or what went wrong."""
        scene, *options = RENDERS[kind]
        if self.is_slow:
            options = ["--time" if option == "--target-error" else "0.001" if option == "1" else option for option in options]
        image, outside = self.path(kind + ".exr")
        stats, stats_outside = self.path("stats.json")
        done = self.run("render", ("/pencil/" if self.inside else "") + f"scenes/{scene}.xml", "-o", image, "--stats", stats, "--seed", "1",
                        "--resolution", TINY if self.is_slow else SIZE, "--quiet", *options)
        if done.returncode:
            return done.stderr.strip().splitlines()[-1] if done.stderr.strip() else f"status {done.returncode}"
        with open(stats_outside, encoding="utf-8") as file:
            read = json.load(file)
        return read["kernel_build_seconds"], sum(s["device_seconds"] for s in read["stages"]), outside


def relmse(image, reference):
    done = subprocess.run([PROGRAM, "compare", image, reference, "--json"], capture_output=True, text=True, check=True)
    return next(layer for layer in json.loads(done.stdout)["layers"] if layer["name"] == "beauty")["rel_mse"]


def measure(runtime, references):
    """Cells of the row, and whether all is well."""
    runtime.clear()
    test = runtime.run("devices", "--self-test")
    well = test.returncode == 0
    cells, built, kernels = ["passed" if well else "FAILED"], 0, 0
    cold = 0
    for kind in RENDERS:
        if "oclgrind" in runtime.name:  # minutes for a pixel
            cells.append("")
            continue
        first = runtime.render(kind)
        if isinstance(first, str):
            cells.append("FAILED: " + first)
            well = False
            continue
        cold += first[0]
        warm = runtime.render(kind)
        built, kernels = built + warm[0], kernels + warm[1]
        reference = references.setdefault((kind, runtime.is_slow), first[2])
        difference = relmse(first[2], reference)
        well = well and difference <= (MOST_LOBES if kind == "lobes" else MOST)
        cells.append("0" if difference == 0 else f"{difference:.1e}")
    return cells, cold, built, kernels, well


def main():
    folder = sys.argv[1]
    with open(os.path.join(folder, "runtimes"), encoding="utf-8") as file:
        runtimes = [Runtime(*line.rstrip("\n").split("\t"), folder) for line in file]
    # The same images tiny, for runtimes that are slow.
    tiny = Runtime("PoCL, tiny", " ".join(runtimes[0].prefix), folder)
    tiny.is_slow = True
    references, fine, usual = {}, True, {}
    measure(tiny, references)
    print("| runtime | self-test | " + " | ".join(f"relMSE, {kind}" for kind in RENDERS) + " | builds [s], cold | warm | kernel time / PoCL |")
    print("|---|---|" + "---|" * len(RENDERS) + "---|---|---|")
    for runtime in runtimes:
        try:
            cells, cold, built, kernels, well = measure(runtime, references)
        except (subprocess.SubprocessError, StopIteration, OSError) as error:
            print(f"| {runtime.name} | {error} |")
            fine = False
            continue
        fine = fine and well
        usual.setdefault(runtime.is_slow, kernels)
        ratio = "" if runtime.is_slow else f"{kernels / usual[False]:.2f}"
        print(f"| {runtime.name} | " + " | ".join(cells) + f" | {cold:.1f} | {built:.2f} | {ratio} |", flush=True)
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
