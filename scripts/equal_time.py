#!/usr/bin/env python3
"""equal_time.py OLD NEW [--time S] [--seeds N] [--keep DIR] [--reference-time S] SCENE [SCENE ...]: error of two versions in the same time.

OLD and NEW are pencil programs; OLD may be the word "reference": NEW's path tracer. Each renders every scene with --time S, the two in turn, seed after
seed, WIDTHxHEIGHT as in SCENE:WIDTHxHEIGHT. Errors are relMSE against two references of NEW's `pencil reference`, whose noise is taken off; the table has the medians and their ratio. References are kept in
DIR and used again. Needs python3-numpy and python3-openimageio."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from trust import pixels  # noqa: E402


def run(*command):
    subprocess.run([str(c) for c in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def render(program, new, *options):
    run(*((new, 'reference') if program == 'reference' else (program, 'render')), *options)


def error(file, first, second):
    """relMSE of an image: the product of its differences from two independent references has no noise of theirs in the mean."""
    mean = (first + second) / 2
    level = mean.mean(axis=2, keepdims=True)
    return float(((pixels(file) - first) * (pixels(file) - second) / (level**2 + 0.01 * level.mean()**2)).mean())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('programs', nargs=2, metavar='PENCIL')
    parser.add_argument('scenes', nargs='+', metavar='SCENE:WIDTHxHEIGHT')
    parser.add_argument('--time', type=float, default=2)
    parser.add_argument('--seeds', type=int, default=3)
    parser.add_argument('--keep', type=pathlib.Path)
    parser.add_argument('--reference-time', type=float, default=60)
    options = parser.parse_args()
    keep = options.keep or pathlib.Path(tempfile.mkdtemp())
    keep.mkdir(parents=True, exist_ok=True)
    print('| scene | old relMSE | new relMSE | new / old |\n|---|---|---|---|')
    for entry in options.scenes:
        scene, size = entry.rsplit(':', 1)
        references = [keep / f'{pathlib.Path(scene).stem}-{size}-reference-{k}.exr' for k in (1, 2)]
        for k, file in enumerate(references):
            if not file.exists():
                run(options.programs[1], 'reference', scene, '-o', file, '--resolution', size, '--time', options.reference_time, '--seed', 101 + k)
        truth, found = [pixels(file) for file in references], ([], [])
        image = keep / 'image.exr'
        for program in options.programs:  # its kernels are built before the clock counts
            render(program, options.programs[1], scene, '-o', image, '--resolution', size, '--time', 0.1)
        for seed in range(options.seeds):
            for errors, program in zip(found, options.programs):
                render(program, options.programs[1], scene, '-o', image, '--resolution', size, '--time', options.time, '--seed', seed)
                errors.append(error(image, *truth))
        old, new = (float(numpy.median(errors)) for errors in found)
        print(f'| {pathlib.Path(scene).stem} | {old:.2g} | {new:.2g} | {new / old:.2f} |', flush=True)


if __name__ == '__main__':
    main()
