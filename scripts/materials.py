#!/usr/bin/env python3
"""materials.py PENCIL [--time S] [--reference-time S] [--resolution WxH] [--keep DIR] [NAME ...]: scenes of all materials, lights and cameras against the path
tracer.

Renders the scenes of scenes/ that the list below has (or those named) for S seconds each, and compares with `pencil reference`, two seeds of it: mean ratio
with the reference's standard error, true relMSE without the reference's noise, estimated relMSE, seconds. Writes to DIR, for each scene, NAME.png with the
render, the reference and the difference side by side. References are kept in DIR and used again. Ends with 1 if a mean is off by more than 1 % and three
standard errors. Needs python3-numpy, python3-pil and python3-openimageio."""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy
from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from trust import pixels  # noqa: E402

SCENES = pathlib.Path(__file__).resolve().parent.parent / 'scenes'
NAMES = ['glossy-plates.xml', 'still-life.xml', 'textured-room.xml', 'lamp-hall.xml', 'office.xml', 'interior.glb']


def displayed(image, exposure):
    x = numpy.clip(numpy.nan_to_num(image) * exposure, 0, 1)
    return numpy.where(x <= 0.0031308, 12.92 * x, 1.055 * x**(1 / 2.4) - 0.055)


def write_pictures(file, image, truth):
    """Render, reference, and the difference about grey: bright where the render is, in units of the displayed value."""
    luminance = truth @ [0.2126, 0.7152, 0.0722]
    lit = luminance[luminance > 0]
    exposure = 0.18 / numpy.median(lit) if lit.size else 1.0
    one, two = displayed(image, exposure), displayed(truth, exposure)
    row = numpy.concatenate([one, two, numpy.clip(0.5 + 2 * (one - two), 0, 1)], axis=1)
    Image.fromarray((row * 255 + 0.5).astype(numpy.uint8)).save(file)


class Materials:
    def __init__(self, arguments, folder):
        self.pencil, self.folder, self.size = arguments.pencil, folder, arguments.resolution
        self.seconds, self.budget = arguments.time, arguments.reference_time

    def run(self, command, file, *more):
        run = subprocess.run([self.pencil, command, *more, '-o', file, '--resolution', self.size, '--aov', 'none', '--quiet'], capture_output=True, text=True)
        if run.returncode:
            raise SystemExit(f'{file}: {run.stderr}')

    def reference(self, scene, name):
        files = [self.folder / f'{name}-{self.size}-reference-{seed}.exr' for seed in (1, 2)]
        for seed, file in enumerate(files, 1):
            if not file.exists():
                self.run('reference', file, scene, '--time', str(self.budget), '--seed', str(seed))
        return [pixels(file) for file in files]

    def measure(self, scene):
        """False if the mean is wrong."""
        name = scene.stem
        one, two = self.reference(scene, name)
        truth, mean = (one + two) / 2, (one + two).mean() / 2
        scale = truth**2 + 0.01 * mean**2
        noise = ((one - two)**2 / 4 / scale).mean()
        error = max(abs(one.mean() - two.mean()) / 2 / mean, math.sqrt(((one - two)**2).sum()) / 2 / truth.size / mean)
        image, stats = self.folder / f'{name}.exr', self.folder / f'{name}.json'
        begun = time.time()
        self.run('render', image, scene, '--time', str(self.seconds), '--stats', stats)
        seconds = time.time() - begun
        found, claimed = pixels(image), json.loads(stats.read_text())['estimated_relmse'] or math.nan
        holes = int((~numpy.isfinite(found)).sum())
        ratio, true = found.mean() / mean, max(((found - truth)**2 / scale).mean() - noise, 0)
        off = holes > 0 or abs(ratio - 1) > 0.01 + 3 * error
        faults = (' OFF' if off else '') + (f' {holes} VALUES NOT FINITE' if holes else '')
        print(f'| {scene.name} | {ratio:.4f} +- {error:.4f} | {true:.1e} (noise {noise:.0e}) | {claimed:.1e} | {seconds:.1f} |{faults}', flush=True)
        write_pictures(self.folder / f'{name}.png', found, truth)
        return not off


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('pencil')
    parser.add_argument('names', nargs='*', default=NAMES)
    parser.add_argument('--time', type=float, default=10)
    parser.add_argument('--reference-time', type=float, default=20)
    parser.add_argument('--resolution', default='160x120')
    parser.add_argument('--keep')
    arguments = parser.parse_intermixed_args()
    folder = pathlib.Path(arguments.keep or tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    materials = Materials(arguments, folder)
    print('| scene | mean ratio | true relMSE | estimated | seconds |\n|---|---|---|---|---|')
    right = [materials.measure(SCENES / name) for name in arguments.names]
    print(f'{len(right)} scenes: {right.count(False)} off by more than 1 % and three standard errors; files in {folder}')
    return 0 if all(right) else 1


if __name__ == '__main__':
    sys.exit(main())
