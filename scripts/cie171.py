#!/usr/bin/env python3
"""cie171.py PENCIL [--method surface|reference] [--time S] [--limit PERCENT] [CASE ...]: tests 5.2 to 5.8 of CIE 171:2006.

"Test Cases to Assess the Accuracy of Lighting Computer Programs": illuminances that are known in closed form. Builds the scenes, measures them with
`pencil measure` for S seconds each and prints a table. Expected values are worked out here, not taken from the printed tables, of which some are
wrong (I. Ashdown, "CIE 171:2006 - Errata"): Lambert's formula for polygons, energy balance, Fresnel's equations. Geometry is that of the published
descriptions; where these leave something open it is said at the case. Ends with 1 if an error exceeds the limit.
"""
import argparse
import csv
import io
import pathlib
import subprocess
import sys
import tempfile

import cie171_scenes as scenes


def measure(arguments, folder, scene, sensors, lumens):
    """Rows of the table of `pencil measure`; `sensors`: [(label, position, normal)], those of meters follow."""
    (folder / 'scene.xml').write_text(scene)
    command = [arguments.pencil, 'measure', str(folder / 'scene.xml'), '--quiet', '--method', arguments.method, '--time', str(arguments.time),
               '--lumens-per-watt', repr(lumens)]
    if sensors:
        (folder / 'points.csv').write_text(''.join(','.join(repr(float(v)) for v in (*at, *normal)) + '\n' for _, at, normal in sensors))
        command += ['--points', str(folder / 'points.csv')]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f'{" ".join(command)}: {run.stderr}')
    return [{k: v if k == 'sensor' or v == '' else float(v) for k, v in row.items()} for row in csv.DictReader(io.StringIO(run.stdout))]


def error(measured, expected, scale):
    """In per cent of what is expected, or, where that is darkness, of the brightest point."""
    return 100 * (measured - expected) / (expected if expected > 0 else scale)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('pencil', type=pathlib.Path)
    parser.add_argument('--method', default='surface', choices=['surface', 'reference'])
    parser.add_argument('--time', type=float, default=6)
    parser.add_argument('--limit', type=float, default=0.3, help='greatest error that is no failure [%%]')
    parser.add_argument('cases', nargs='*', metavar='CASE', help='like 5.8, default all')
    arguments = parser.parse_intermixed_args()
    arguments.pencil = arguments.pencil.resolve()
    print('| case | point | expected | measured | error % |\n|---|---|---|---|---|')
    worst, held, count = {}, 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for case in scenes.cases(folder):
            if arguments.cases and case.number not in arguments.cases:
                continue
            rows = measure(arguments, folder, case.scene, case.sensors, case.lumens)
            scale = max(value for _, value in case.expected)
            for (point, expected), value, low, high in case.results(rows):
                off = error(value, expected, scale)
                worst[case.number] = max(worst.get(case.number, 0), abs(off))
                held += low <= expected * (1 + 1e-9) and expected <= high * (1 + 1e-9)
                count += 1
                print(f'| {case.number} {case.name} | {point} | {expected:.5g} | {value:.5g} | {off:+.2f} |', flush=True)
    print('\n| case | greatest error % |\n|---|---|')
    for number, off in worst.items():
        print(f'| {number} | {off:.2f} |')
    print(f'\n{held} of {count} intervals hold what is expected.')
    return int(any(off > arguments.limit for off in worst.values()))


if __name__ == '__main__':
    sys.exit(main())
