#!/usr/bin/env python3
"""seeds.py PENCIL [PENCIL ...] --scene SCENE:WIDTHxHEIGHT [--seeds N] [--options "..."]: how much images of different seeds differ.

Renders a scene with each program and each seed, by default options or those given, and prints for each program the mean number of passes and seconds,
the relMSE of a seed's image against the mean of all programs' images (no reference: what all seeds share is not seen), the standard deviation of
the means of images, and the largest of their errors that a render claims. Needs python3-numpy and python3-openimageio."""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from trust import pixels  # noqa: E402


def render(program, scene, seed, options, folder):
    file, size = scene.rsplit(':', 1)
    image, stats = folder / 'image.exr', folder / 'stats.json'
    subprocess.run([program, 'render', file, '-o', str(image), '--resolution', size, '--seed', str(seed), '--stats', str(stats), '--quiet', *options],
                   check=True, stderr=subprocess.DEVNULL)
    said = json.loads(stats.read_text())
    return numpy.asarray(pixels(image), float), said['passes'], said['total_wall_seconds'], said.get('estimated_relmse') or numpy.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('programs', nargs='+', metavar='PENCIL')
    parser.add_argument('--scene', required=True, metavar='SCENE:WIDTHxHEIGHT')
    parser.add_argument('--seeds', type=int, default=5)
    parser.add_argument('--options', type=shlex.split, default=[])
    options = parser.parse_args()
    runs = {program: [] for program in options.programs}
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, options.seeds + 1):
            for program in options.programs:  # by turns: the machine is not always as fast
                runs[program].append(render(program, options.scene, seed, options.options, pathlib.Path(folder)))
    shown = numpy.mean([run[0] for of_program in runs.values() for run in of_program], axis=0)
    level = shown.mean(axis=2, keepdims=True)
    print('| program | passes | seconds | relMSE among seeds | means vary by | largest claim |\n|---|---|---|---|---|---|')
    for program, of_program in runs.items():
        images, passes, seconds, claims = zip(*of_program)
        variance = numpy.var(images, axis=0, ddof=1)
        means = numpy.mean(images, axis=(1, 2, 3))
        print(f'| {program} | {numpy.mean(passes):.0f} | {numpy.mean(seconds):.1f} | {(variance / (level**2 + 0.01 * level.mean()**2)).mean():.2g} | '
              f'{100 * means.std(ddof=1) / means.mean():.2g} % | {numpy.nanmax(claims):.2g} |')


if __name__ == '__main__':
    main()
