#!/usr/bin/env python3
"""make_textures.py [FOLDER]: writes the pictures of scenes/textured-room.xml into scenes/textures, or into another folder: floor, wall, bricks with their
normals, a painting, heights of a fabric, the opacity of a leaf, and a sky. Equal on every run. Needs python3-numpy and python3-pil."""
import pathlib
import sys

import numpy
from PIL import Image


def noise(rng, height, width, cells_y, cells_x):
    """Smooth values in [0, 1] that repeat at the edges: a grid of random ones, between them a cubic in each direction."""
    grid = rng.random((cells_y, cells_x))
    y, x = numpy.arange(height) * cells_y / height, numpy.arange(width) * cells_x / width
    j, i = y.astype(int), x.astype(int)
    fy, fx = (y - j)[:, None], (x - i)[None, :]
    fy, fx = fy * fy * (3 - 2 * fy), fx * fx * (3 - 2 * fx)
    at = lambda dj, di: grid[numpy.ix_((j + dj) % cells_y, (i + di) % cells_x)]
    return (at(0, 0) * (1 - fx) + at(0, 1) * fx) * (1 - fy) + (at(1, 0) * (1 - fx) + at(1, 1) * fx) * fy


def picture(values):
    return Image.fromarray(numpy.clip(numpy.rint(values * 255), 0, 255).astype(numpy.uint8))


def mixed(weight, low, high):
    return numpy.asarray(low) + weight[..., None] * (numpy.asarray(high) - numpy.asarray(low))


def boards(rng):
    """Eight boards across, each of a shade of its own, with their grain."""
    size, count = 128, 8
    board = numpy.arange(size) * count // size
    grain = noise(rng, size, size, 4, 64) * 0.5 + noise(rng, size, size, 2, 32) * 0.5
    shade = 0.75 + 0.25 * rng.random(count)[board][None, :]
    image = mixed(grain, (0.42, 0.27, 0.16), (0.66, 0.47, 0.3)) * shade[..., None]
    image[:, numpy.arange(size) % (size // count) == 0] *= 0.35
    return picture(image).quantize(48)


def wallpaper(_):
    size = 64
    y, x = numpy.mgrid[0:size, 0:size] / size * 2 * numpy.pi
    leaf = (numpy.cos(x) * numpy.cos(y) + 0.5 * numpy.cos(2 * x + 2 * y) > 0.55).astype(float)
    return picture(mixed(leaf, (0.83, 0.79, 0.66), (0.5, 0.6, 0.46))).quantize(8)


def brick_heights(rng):
    size, rows, columns = 128, 8, 4
    y, x = numpy.mgrid[0:size, 0:size] / size
    row = numpy.floor(y * rows)
    across = x * columns + 0.5 * (row % 2)
    dx, dy = numpy.abs(across % 1 - 0.5), numpy.abs(y * rows % 1 - 0.5)
    edge = numpy.minimum((0.5 - dx) * size / columns, (0.5 - dy) * size / rows)  # texels to the mortar's middle
    flat = numpy.clip((edge - 1) / 2, 0, 1)
    number = (row * columns + numpy.floor(across) % columns).astype(int)
    return flat, number, flat * (0.9 + 0.1 * noise(rng, size, size, 32, 32))


def bricks(rng):
    flat, number, _ = brick_heights(rng)
    shade = rng.random(number.max() + 1)[number]
    return picture(mixed(flat, (0.62, 0.6, 0.56), (0.0, 0.0, 0.0)) + flat[..., None] * mixed(shade, (0.45, 0.2, 0.14), (0.62, 0.31, 0.22))).quantize(48)


def brick_normals(rng):
    """(n + 1) / 2, x to the right, y up."""
    _, _, height = brick_heights(rng)
    slope_x = numpy.roll(height, -1, 1) - numpy.roll(height, 1, 1)
    slope_y = numpy.roll(height, -1, 0) - numpy.roll(height, 1, 0)
    n = numpy.dstack([-slope_x, slope_y, numpy.ones_like(height)])
    return picture((n / numpy.linalg.norm(n, axis=2, keepdims=True) + 1) / 2)


def painting(rng):
    height, width = 96, 128
    y, x = numpy.mgrid[0:height, 0:width] / [[[height]], [[width]]]
    image = mixed(y, (0.2, 0.4, 0.7), (0.9, 0.75, 0.5))
    image[(x - 0.7)**2 * 1.8 + (y - 0.35)**2 < 0.012] = (0.95, 0.85, 0.4)
    for k, colour in enumerate(((0.45, 0.5, 0.55), (0.3, 0.42, 0.3), (0.16, 0.24, 0.14))):
        ridge = 0.5 + 0.14 * k + 0.25 * (noise(rng, 1, width, 1, 4 + 2 * k)[0] - 0.5)
        image[y > ridge[None, :]] = colour
    return picture(image).quantize(32)


def fabric(_):
    size = 64
    y, x = numpy.mgrid[0:size, 0:size] / size * 2 * numpy.pi
    over = numpy.sign(numpy.sin(4 * x) * numpy.sin(4 * y))
    return picture(numpy.where(over > 0, numpy.abs(numpy.sin(8 * x)), numpy.abs(numpy.sin(8 * y))) * 0.8 + 0.1).quantize(16).convert('L')


def leaf(_):
    size = 64
    y, x = numpy.mgrid[0:size, 0:size] / (size - 1)
    width = 0.42 * numpy.sin(numpy.pi * y)**0.8 * (1 - 0.25 * (numpy.sin(14 * numpy.pi * y) > 0.6))
    inside = numpy.abs(x - 0.5) < width
    rib = (numpy.abs(x - 0.5) < 0.03) | (numpy.abs((numpy.abs(x - 0.5) - y) * 6 % 1) < 0.12)
    colour = mixed(rib.astype(float), (0.2, 0.42, 0.12), (0.4, 0.55, 0.25))
    return picture(numpy.dstack([colour, inside.astype(float)]))


def sky(_):
    """Radiance by latitude and longitude: a horizon brighter than the zenith, a glow about the sun, the sun itself, meadows below."""
    width, height = 128, 64
    v, u = numpy.mgrid[0:height, 0:width] + 0.5
    up, turn = numpy.cos(v / height * numpy.pi), u / width * 2 * numpy.pi
    across = numpy.sqrt(1 - up**2)
    d = numpy.dstack([across * numpy.sin(turn), up, -across * numpy.cos(turn)])
    row, column = 19, 30  # of the sun
    to_sun = d @ d[row, column]
    clear = mixed(numpy.clip(up, 0, 1)**0.5, (1.5, 1.7, 1.9), (0.35, 0.65, 1.3)) + 3 * numpy.exp(12 * (to_sun - 1))[..., None] * [1, 0.9, 0.7]
    image = numpy.where(up[..., None] > 0, clear, [0.16, 0.2, 0.1])
    image[row, column] = (2400, 2200, 1900)
    return image


def write_hdr(file, image):
    """Radiance RGBE, rows as they are."""
    _, exponent = numpy.frexp(image.max(axis=2))
    bytes_of = numpy.floor(image * numpy.exp2(8.0 - exponent)[..., None]).clip(0, 255)
    pixels = numpy.dstack([bytes_of, exponent + 128]).astype(numpy.uint8)
    file.write_bytes(b'#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n' % image.shape[:2] + pixels.tobytes())


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent / 'scenes' / 'textures'
    folder.mkdir(parents=True, exist_ok=True)
    pictures = {'boards': boards, 'wallpaper': wallpaper, 'bricks': bricks, 'brick-normals': brick_normals, 'painting': painting, 'fabric': fabric,
                'leaf': leaf}
    for name, make in pictures.items():
        make(numpy.random.default_rng(1)).save(folder / f'{name}.png', optimize=True)
    write_hdr(folder / 'sky.hdr', sky(None))
    for file in sorted(folder.iterdir()):
        print(f'{file.name:20} {file.stat().st_size:6} bytes')


if __name__ == '__main__':
    main()
