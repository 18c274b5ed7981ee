#!/usr/bin/env python3
"""trust.py PENCIL [--random N] [--seed S] [--keep DIR] [--reference-time S] [--limit S] [NAME ...]: is it right, and does it know when it is not?

Renders the scenes of scenes/trust (or those named), or N random rooms, with default options, and compares with `pencil reference`, two seeds of it:
mean ratio with the reference's standard error, true relMSE with its own, estimated relMSE, seconds. The true error is the mean of (x - r1) (x - r2) over the square that relMSE has
with x for the reference: the noise of two references falls out, and pixels that neither has found do not decide. References are kept in DIR and used again. Ends with 1 if a mean is
off by more than 1 % and three standard errors, an error is, by two standard errors, more than twice what is claimed, or a render takes longer than the limit. Random rooms of one
seed are the same everywhere.
Needs python3-numpy and python3-openimageio."""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import numpy
import OpenImageIO

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import make_trust_scenes as parts  # noqa: E402

TRUST = pathlib.Path(__file__).resolve().parent.parent / 'scenes' / 'trust'
VARIANTS = [('bright-room', 'albedo=0.97'), ('bright-room', 'albedo=0.99'), ('ground-plane', 'extent=1e4'), ('ground-plane', 'extent=1e6'),
            ('far-light', 'distance=1e4', 'size=2.5e3'), ('far-light', 'distance=1e6', 'size=2.5e5')]


def pixels(file):
    image = OpenImageIO.ImageInput.open(str(file))
    spec = image.spec()
    values = numpy.asarray(image.read_image(0, 0, 0, spec.nchannels, 'float'), float).reshape(spec.height, spec.width, spec.nchannels)
    image.close()
    return values[..., [spec.channelnames.index(c) for c in 'RGB']]


def random_room(rng, folder, name):
    """A room with what rooms have: thick or thin walls, a window, a second room behind a doorway, things, lamps that are seen, hidden or outside."""
    w, h, d = rng.uniform(2, 7), rng.uniform(2, 4), rng.uniform(2, 7)
    wall = 10 ** rng.uniform(-2.5, -0.5)
    bright = rng.choice([0.2, 0.5, 0.7, 0.8, 0.9, 0.95])
    colour = lambda: parts.diffuse(*[bright * rng.uniform(0.5, 1) for _ in range(3)])
    window, doorway = rng.random() < 0.4, rng.random() < 0.4
    body = parts.room(wall, (0, 0, 0), (w, h, d), colour(), open_sides=('x-', ) if window else ())
    if window:
        low, high = h * rng.uniform(0, 0.5), h * rng.uniform(0.6, 0.95)
        body += parts.wall_with_hole(-wall, wall, -wall, d + wall, h, (d * rng.uniform(0.1, 0.4), d * rng.uniform(0.5, 0.9), low, high), colour())
        far = 10 ** rng.uniform(1.5, 4)
        body += parts.sky(3 * far, 10 ** rng.uniform(-0.5, 1.5))
        if rng.random() < 0.6:
            body += parts.box((-far, -wall - 1, -far), (far, -wall, far), colour())
    if doorway:
        a = d * rng.uniform(0.05, 0.6)
        body += parts.wall_with_hole(w * rng.uniform(0.35, 0.6), wall, 0, d, h, (a, min(a + rng.uniform(0.05, 1), d), 0, h * rng.uniform(0.5, 0.95)), colour())
    for _ in range(rng.randrange(6)):
        size = [rng.uniform(0.05, 0.9) for _ in range(3)]
        low = [rng.uniform(0.02, max(w - size[0], 0.1)), rng.choice([0, 0, 0.004, rng.uniform(0, h / 2)]), rng.uniform(0.02, max(d - size[2], 0.1))]
        if rng.random() < 0.6:
            body += parts.box(low, [a + b for a, b in zip(low, size)], colour())
        else:
            body += parts.ball([a + b / 2 for a, b in zip(low, size)], min(size) / 2, colour())
    if not window or rng.random() < 0.5:
        size = 10 ** rng.uniform(-1.7, -0.3)
        power = 0.05 * w * d / size**2
        at = (rng.uniform(0.1, 0.9) * w, h - rng.choice([0.004, 0.15, 0.6]), rng.uniform(0.1, 0.9) * d)
        lit = parts.BLACK + parts.emitter(*[power * rng.uniform(0.6, 1) for _ in range(3)])
        body += parts.floor_like(size, size, at, lit, rng.random() < 0.3) if rng.random() < 0.6 else parts.ball((at[0], at[1] - size, at[2]), 0.7 * size, lit)
    eye = [rng.uniform(0.15, 0.85) * x for x in (w, h, d)]
    parts.OUT = folder
    parts.scene(name, f'A random room, walls {wall:.3f}, albedo {bright}', eye, [rng.uniform(0.1, 0.9) * x for x in (w, h, d)], body, rng.uniform(40, 100))
    return folder / f'{name}.xml'


class Trust:
    def __init__(self, arguments, folder, more=()):
        self.more, self.pencil, self.folder, self.budget = list(more), arguments.pencil, folder, arguments.reference_time
        self.limit = arguments.limit
        self.off = self.low = self.endless = self.count = 0

    def reference(self, name, scene, defines):
        files = [self.folder / f'{name}-reference-{seed}.exr' for seed in (1, 2)]
        for seed, file in enumerate(files, 1):
            if not file.exists():
                subprocess.run([self.pencil, 'reference', scene, '-o', file, '--time', str(self.budget), '--seed', str(seed), '--aov', 'none', '--quiet', *self.more, *defines],
                               check=True)
        return [pixels(file) for file in files]

    def measure(self, name, scene, defines=()):
        defines = [x for d in defines for x in ('-D', d)]
        one, two = self.reference(name, scene, defines)
        mean = (one + two).mean() / 2
        if mean <= 0:
            return
        error = max(abs(one.mean() - two.mean()) / 2 / mean, math.sqrt(((one - two)**2).sum()) / 2 / one.size / mean)
        image, stats = self.folder / f'{name}.exr', self.folder / f'{name}.json'
        begun = time.time()
        try:
            run = subprocess.run([self.pencil, 'render', scene, '-o', image, '--stats', stats, '--quiet', *self.more, *defines], capture_output=True, text=True,
                                 timeout=self.limit)
        except subprocess.TimeoutExpired:
            self.count, self.endless = self.count + 1, self.endless + 1
            print(f'| {name} | no end in {self.limit:.0f} s |  |  |  |', flush=True)
            return
        seconds = time.time() - begun
        if run.returncode:
            raise SystemExit(f'{name}: {run.stderr}')
        found, claimed = pixels(image), json.loads(stats.read_text())['estimated_relmse'] or math.nan
        squares = ((found - one) * (found - two) / (found**2 + 0.01 * mean**2)).mean(axis=2)
        ratio, true, noise = found.mean() / mean, squares.mean(), squares.std() / math.sqrt(squares.size)
        off, low = not abs(ratio - 1) <= 0.01 + 3 * error, not true - 2 * noise <= 2 * claimed  # what is NaN is wrong
        self.count, self.off, self.low = self.count + 1, self.off + off, self.low + low
        print(f'| {name} | {ratio:.4f} +- {error:.4f} | {true:.1e} +- {noise:.0e} | {claimed:.1e} | {seconds:.1f} |'
              f'{" OFF" if off else ""}{" CLAIMS TOO LITTLE" if low else ""} {run.stderr.strip()[:60]}', flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('pencil')
    parser.add_argument('names', nargs='*')
    parser.add_argument('--random', type=int, default=0)
    parser.add_argument('--seed', type=int, default=random.SystemRandom().randrange(1 << 30))
    parser.add_argument('--keep')
    parser.add_argument('--reference-time', type=float, default=20)
    parser.add_argument('--limit', type=float, default=60)
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.keep or tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    trust = Trust(arguments, folder)
    print('| scene | mean ratio | true relMSE | estimated | seconds |\n|---|---|---|---|---|')
    if arguments.random:
        for seed in range(arguments.seed, arguments.seed + arguments.random):
            trust.measure(f'room-{seed}', random_room(random.Random(seed), folder, f'room-{seed}'))
    else:
        scenes = [(file.stem, ) for file in sorted(TRUST.glob('*.xml'))] + VARIANTS
        for name, *defines in scenes:
            if not arguments.names or name in arguments.names:
                trust.measure('-'.join([name, *defines]), TRUST / f'{name}.xml', defines)
    print(f'{trust.count} scenes: {trust.off} off by more than 1 % and three standard errors, {trust.low} with more than twice the claimed error, '
          f'{trust.endless} without end; '
          f'seed {arguments.seed}, files in {folder}')
    return 1 if trust.off or trust.low or trust.endless else 0


if __name__ == '__main__':
    sys.exit(main())
