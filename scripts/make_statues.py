#!/usr/bin/env python3
"""make_statues.py FOLDER [--triangles N]: a scene of many triangles, four rough statues in a lit room.

Writes statues.xml and its meshes, about N triangles in all, into FOLDER; the same on every run. Needs python3-numpy.
"""
import argparse
from pathlib import Path

import numpy as np

STATUES = ((-3, -1.5), (-1, 0), (1.2, -1), (3, 0.5))
HEAD = """<scene version="3.0.0">
<integrator type="path"/>
<sensor type="perspective">
    <float name="fov" value="60"/>
    <transform name="to_world"><lookat origin="0, 2.2, 6.5" target="0, 1.3, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="320"/><integer name="height" value="180"/></film>
</sensor>
<bsdf type="twosided" id="stone"><bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.7, 0.65"/></bsdf></bsdf>
<shape type="cube">
    <transform name="to_world"><scale x="5" y="2.5" z="6.5"/><translate y="2.5" z="2.5"/></transform>
    <ref id="stone"/>
</shape>
<shape type="rectangle">
    <transform name="to_world"><scale x="1" y="0.6"/><rotate x="1" angle="90"/><translate y="4.95"/></transform>
    <emitter type="area"><rgb name="radiance" value="18, 16, 13"/></emitter>
</shape>
"""
STATUE = """<shape type="ply">
    <string name="filename" value="statue-{0}.ply"/>
    <transform name="to_world"><translate x="{1}" y="1.2" z="{2}"/></transform>
    <ref id="stone"/>
</shape>
"""


def statue(rings, seed):
    """A sphere of rings x 2 rings quadrangles, its radius a sum of waves in six octaves."""
    random = np.random.default_rng(seed)
    v, u = np.meshgrid(np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings + 1), indexing="ij")
    points = np.stack([np.sin(v) * np.cos(u), np.cos(v), np.sin(v) * np.sin(u)], -1)
    radius = np.ones(u.shape)
    for octave in range(6):
        for _ in range(4):
            way = random.normal(size=3)
            waves = np.sin(4 * 2**octave * (points @ (way / np.linalg.norm(way))) + random.uniform(0, 2 * np.pi))
            radius += 0.06 / 2**octave * waves
    index = np.arange(u.size, dtype="<i4").reshape(u.shape)
    a, b, c, d = (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1])
    triangles = np.concatenate([np.stack([a, b, c], -1)[1:].reshape(-1, 3), np.stack([a, c, d], -1)[:-1].reshape(-1, 3)])
    return (points * radius[..., None]).reshape(-1, 3).astype("<f4"), triangles


def write_ply(path, points, triangles):
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    path.write_bytes(head.encode() + points.tobytes() + faces.tobytes())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--triangles", type=int, default=1000000)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    rings = max(round((arguments.triangles / (4 * len(STATUES))) ** 0.5), 3)
    text = HEAD
    for k, (x, z) in enumerate(STATUES):
        write_ply(arguments.folder / f"statue-{k}.ply", *statue(rings, k))
        text += STATUE.format(k, x, z)
    (arguments.folder / "statues.xml").write_text(text + "</scene>\n")


if __name__ == "__main__":
    main()
