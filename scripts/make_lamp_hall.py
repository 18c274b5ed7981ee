#!/usr/bin/env python3
"""make_lamp_hall.py: writes scenes/lamp-hall.xml and the 1000 lamps that it includes, scenes/meshes/lamps.xml. Equal on every run."""
import math
import pathlib
import random

SCENES = pathlib.Path(__file__).resolve().parent.parent / 'scenes'
COLOURS = {'candle': (230, 130, 50), 'amber': (200, 140, 70), 'white': (150, 145, 135), 'moon': (110, 130, 170), 'rose': (190, 100, 110)}
WIDTH, HEIGHT, LENGTH = 8, 6, 20  # of the hall

HALL = '''<?xml version="1.0" encoding="utf-8"?>
<!-- A hall of 8 x 6 x 20 with 1000 lamps of 5 x 5 cm that hang from its ceiling in waves and face down, each an emitter of its own, in five colours. Its floor is
     polished, its columns are lacquered. Each lamp lights little: what is hard is to choose among them. Written by scripts/make_lamp_hall.py. -->
<scene version="3.0.0">
    <default name="max_depth" value="-1"/>
    <default name="width" value="320"/>
    <default name="height" value="240"/>

    <integrator type="path">
        <integer name="max_depth" value="$max_depth"/>
    </integrator>

    <sensor type="perspective">
        <float name="fov" value="65"/>
        <transform name="to_world">
            <lookat origin="-1.2, 1.7, 19" target="0.4, 2.1, 8" up="0, 1, 0"/>
        </transform>
        <film type="hdrfilm">
            <integer name="width" value="$width"/>
            <integer name="height" value="$height"/>
            <rfilter type="box"/>
        </film>
    </sensor>

    <bsdf type="diffuse" id="stone"><rgb name="reflectance" value="0.55, 0.5, 0.44"/></bsdf>
    <bsdf type="twosided" id="polished">
        <bsdf type="roughplastic"><rgb name="diffuse_reflectance" value="0.25, 0.2, 0.17"/><float name="alpha" value="0.05"/></bsdf>
    </bsdf>
    <bsdf type="twosided" id="lacquer">
        <bsdf type="roughplastic"><rgb name="diffuse_reflectance" value="0.5, 0.12, 0.1"/><float name="alpha" value="0.15"/></bsdf>
    </bsdf>
EMITTERS
    <shape type="cube" id="hall">
        <transform name="to_world"><scale x="4" y="3" z="10"/><translate y="3" z="10"/></transform>
        <boolean name="flip_normals" value="true"/>
        <ref id="stone"/>
    </shape>
    <shape type="rectangle" id="floor">
        <transform name="to_world"><scale x="3.9" y="9.9"/><rotate x="1" angle="-90"/><translate y="0.005" z="10"/></transform>
        <ref id="polished"/>
    </shape>
COLUMNS
    <include filename="meshes/lamps.xml"/>
</scene>
'''


def columns():
    for k, (x, z) in enumerate((x, z) for z in (3, 7, 11, 15) for x in (-2.8, 2.8)):
        yield (f'    <shape type="cylinder" id="column {k + 1}">\n        <point name="p0" x="{x}" y="0" z="{z}"/><point name="p1" x="{x}" y="6" z="{z}"/>'
               f'<float name="radius" value="0.25"/>\n        <ref id="lacquer"/>\n    </shape>')


def lamps():
    """20 rows of 50, shaken, at heights of two waves."""
    rng = random.Random(1)
    for k in range(1000):
        x = (k % 20 + rng.uniform(0.2, 0.8)) / 20 * (WIDTH - 1) - (WIDTH - 1) / 2
        z = (k // 20 + rng.uniform(0.2, 0.8)) / 50 * (LENGTH - 1) + 0.5
        y = 4.3 + 0.7 * math.sin(0.9 * z) * math.cos(0.8 * x) + rng.uniform(-0.3, 0.3)
        yield (f'<shape type="rectangle"><transform name="to_world"><matrix value=".025 0 0 {x:.2f} 0 0 -.025 {y:.2f} 0 .025 0 {z:.2f} 0 0 0 1"/></transform>'
               f'<ref id="{rng.choice(list(COLOURS))}"/></shape>')


def main():
    emitters = '\n'.join(f'    <emitter type="area" id="{name}"><rgb name="radiance" value="{", ".join(map(str, rgb))}"/></emitter>' for name, rgb in COLOURS.items())
    (SCENES / 'lamp-hall.xml').write_text(HALL.replace('EMITTERS', emitters).replace('COLUMNS', '\n'.join(columns())))
    (SCENES / 'meshes' / 'lamps.xml').write_text('<scene version="3.0.0">\n' + '\n'.join(lamps()) + '\n</scene>\n')


if __name__ == '__main__':
    main()
