#!/usr/bin/env python3
"""random_scenes.py PENCIL [--count N] [--seed S] [--keep DIR] [--reference-time S] [--limit S] [--shrink]: scenes of everything that can be rendered.

Makes N scenes by chance, rooms and things in the open, of all materials, textures, shapes, lights and cameras, renders them with default options at 64x48
and compares with `pencil reference` as scripts/trust.py does: who is off, who claims too little, who never ends. --shrink takes parts away from a scene that
is off as long as it stays off, and leaves NAME-small.xml. One seed makes the same scene everywhere. Ends with 1 if a scene is off or has no end. Needs
python3-numpy and python3-openimageio."""
import argparse
import pathlib
import random
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from trust import Trust  # noqa: E402

SCENES = pathlib.Path(__file__).resolve().parent.parent / 'scenes'
SIZE = 64, 48


def number(name, value):
    return f'<float name="{name}" value="{value:.5g}"/>'


def rgb(name, values):
    return f'<rgb name="{name}" value="{", ".join(f"{v:.4g}" for v in values)}"/>'


def place(*steps):
    return '<transform name="to_world">' + ''.join(steps) + '</transform>'


def vector(tag, v):
    return f'<{tag} x="{v[0]:.5g}" y="{v[1]:.5g}" z="{v[2]:.5g}"/>'


class Maker:
    """A scene by the numbers of one random generator."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.parts = []

    def colour(self, low=0.1, high=0.9):
        level = self.rng.uniform(low, high)
        return [level * self.rng.uniform(0.5, 1) for _ in range(3)]

    def texture(self, name, file=None, raw=False):
        rng = self.rng
        if file is None and rng.random() < 0.3:
            return (f'<texture name="{name}" type="checkerboard">{rgb("color0", self.colour())}{rgb("color1", self.colour())}'
                    f'<transform name="to_uv"><scale x="{rng.randint(1, 8)}" y="{rng.randint(1, 8)}"/></transform></texture>')
        file = file or rng.choice(['boards', 'bricks', 'painting', 'wallpaper', 'fabric'])
        return (f'<texture name="{name}" type="bitmap"><string name="filename" value="{SCENES}/textures/{file}.png"/>'
                f'<boolean name="raw" value="{str(raw).lower()}"/><string name="wrap_mode" value="{rng.choice(["repeat", "mirror", "clamp"])}"/>'
                f'<transform name="to_uv"><scale x="{rng.uniform(0.5, 4):.3g}" y="{rng.uniform(0.5, 4):.3g}"/></transform></texture>')

    def reflectance(self, name):
        return self.texture(name) if self.rng.random() < 0.3 else rgb(name, self.colour())

    def alpha(self):
        rough = number('alpha', 10**self.rng.uniform(-1.3, -0.1))
        return rough + f'<string name="distribution" value="{self.rng.choice(["ggx", "beckmann"])}"/>'

    def plain(self):
        """A material that stands by itself, without its tags' end."""
        rng, metal = self.rng, f'<string name="material" value="{self.rng.choice(["Au", "Ag", "Cu", "Al", "Cr"])}"/>'
        index = number('int_ior', rng.uniform(1.2, 1.8))
        return rng.choice([
            lambda: ('diffuse', self.reflectance('reflectance')),
            lambda: ('diffuse', self.reflectance('reflectance')),
            lambda: ('roughdiffuse', self.reflectance('reflectance') + number('alpha', rng.uniform(0.1, 0.8))),
            lambda: ('plastic', self.reflectance('diffuse_reflectance') + index),
            lambda: ('roughplastic', self.reflectance('diffuse_reflectance') + index + self.alpha()),
            lambda: ('conductor', metal),
            lambda: ('roughconductor', metal + self.alpha()),
            lambda: ('phong', rgb('diffuse_reflectance', self.colour(0.1, 0.5)) + rgb('specular_reflectance', self.colour(0.1, 0.4)) + number(
                'exponent', 10**rng.uniform(0.5, 2.5))),
            lambda: ('principled', self.reflectance('base_color') + number('roughness', rng.uniform(0.1, 1)) + number('metallic', rng.choice([0, 0, 1, 0.5])) +
                     number('clearcoat', rng.choice([0, 0, 1]))),
        ])()

    def glass(self):
        rng, index = self.rng, number('int_ior', self.rng.uniform(1.2, 1.8))
        return rng.choice([('dielectric', index), ('thindielectric', index), ('roughdielectric', index + self.alpha())])

    def material(self, clear=True):
        rng, kind = self.rng, self.rng.random()
        if clear and kind < 0.12:
            name, body = self.glass()
            return f'<bsdf type="{name}">{body}</bsdf>'
        name, body = self.plain()
        inner = f'<bsdf type="{name}">{body}</bsdf>'
        if kind < 0.2:
            other, more = self.plain()
            inner = f'<bsdf type="blendbsdf">{number("weight", rng.random())}{inner}<bsdf type="{other}">{more}</bsdf></bsdf>'
        elif kind < 0.27:
            inner = f'<bsdf type="bumpmap">{self.texture("arbitrary", "fabric", True)}{number("scale", rng.uniform(0.002, 0.02))}{inner}</bsdf>'
        elif kind < 0.34:
            inner = f'<bsdf type="normalmap">{self.texture("normalmap", "brick-normals", True)}{inner}</bsdf>'
        inner = f'<bsdf type="twosided">{inner}</bsdf>'
        if clear and 0.34 < kind < 0.42:
            opacity = number('opacity', rng.uniform(0.2, 0.9)) if rng.random() < 0.5 else self.texture('opacity', 'leaf').replace(
                '<boolean', '<string name="channel" value="a"/><boolean')
            inner = f'<bsdf type="mask">{opacity}{inner}</bsdf>'
        return inner

    def thing(self, at, size):
        """A shape that stands on the floor."""
        rng = self.rng
        turn = f'<rotate y="1" angle="{rng.uniform(0, 360):.4g}"/>'
        kind = rng.choice(['sphere', 'sphere', 'cube', 'cube', 'cylinder', 'rectangle', 'disk', 'mesh'])
        up = 'translate x="{:.5g}" y="{:.5g}" z="{:.5g}"'.format
        if kind == 'sphere':
            body = vector('point name="center"', (at[0], at[1] + size, at[2])) + number('radius', size)
        elif kind == 'cube':
            high = size * rng.uniform(0.3, 2)
            body = place(f'<scale x="{size:.5g}" y="{high:.5g}" z="{size * rng.uniform(0.4, 1):.5g}"/>', turn, f'<{up(at[0], at[1] + high + 1e-3, at[2])}/>')
        elif kind == 'cylinder':
            body = vector('point name="p0"', (at[0], at[1], at[2])) + vector('point name="p1"', (at[0], at[1] + 2 * size, at[2])) + number('radius', 0.5 * size)
        elif kind == 'mesh':
            file = rng.choice(['jug', 'vase', 'bowl'])
            body = (f'<string name="filename" value="{SCENES}/meshes/{file}.ply"/>' +
                    place(f'<scale value="{4 * size:.5g}"/>', turn, f'<{up(at[0], at[1] + 0.01 * size, at[2])}/>'))
            kind = 'ply'
        else:
            body = place(f'<rotate x="1" angle="{rng.uniform(-80, 20):.4g}"/>', turn, f'<scale value="{size:.5g}"/>', f'<{up(at[0], at[1] + 1.1 * size, at[2])}/>')
        self.parts.append(f'<shape type="{kind}">{body}{self.material()}</shape>')

    def lamp(self, at, target, power, unit):
        """A light at a place: a panel, a ball, a point, a spot or a luminaire."""
        rng, tint = self.rng, [rng_value for rng_value in self.colour(0.7, 1)]
        kind, size = rng.choice(['panel', 'panel', 'screen', 'ball', 'point', 'spot', 'ies']), unit * 10**rng.uniform(-1.3, -0.4)
        look = place(f'<lookat origin="{at[0]:.5g}, {at[1]:.5g}, {at[2]:.5g}" target="{target[0]:.5g}, {target[1]:.5g}, {target[2]:.5g}" up="0.1, 0, 1"/>')
        if kind in ('panel', 'screen'):
            level = power / (4 * size**2)
            shine = rgb('radiance', [level * t for t in tint])
            if kind == 'screen':
                shine = self.texture('radiance', rng.choice(['painting', 'wallpaper']))
                size = 0.4 * unit
            shape = rng.choice(['rectangle', 'disk'])
            body = look.replace('<lookat', f'<scale value="{size:.5g}"/><lookat')
            self.parts.append(f'<shape type="{shape}">{body}<emitter type="area">{shine}</emitter></shape>')
        elif kind == 'ball':
            shine = rgb('radiance', [power / (12 * size**2) * t for t in tint])
            self.parts.append(f'<shape type="sphere">{vector("point name=" + chr(34) + "center" + chr(34), at)}{number("radius", size)}'
                              f'<emitter type="area">{shine}</emitter></shape>')
        elif kind == 'point':
            self.parts.append(f'<emitter type="point">{vector("point name=" + chr(34) + "position" + chr(34), at)}{rgb("intensity", [power * t for t in tint])}</emitter>')
        elif kind == 'spot':
            self.parts.append(f'<emitter type="spot">{look}{number("cutoff_angle", rng.uniform(20, 70))}{rgb("intensity", [2 * power * t for t in tint])}</emitter>')
        else:
            self.parts.append(f'<emitter type="ies">{look}<string name="filename" value="{SCENES}/lights/downlight.ies"/>{rgb("intensity", [power] * 3)}</emitter>')

    def sky(self):
        rng = self.rng
        turn = f'<rotate y="1" angle="{rng.uniform(0, 360):.4g}"/>'
        self.parts.append(
            rng.choice([
                lambda: f'<emitter type="constant">{rgb("radiance", self.colour(0.3, 1))}</emitter>',
                lambda: f'<emitter type="envmap"><string name="filename" value="{SCENES}/textures/sky.hdr"/>{place(turn)}</emitter>',
                lambda: f'<emitter type="sunsky">{number("turbidity", rng.uniform(2, 6))}'
                f'{vector("vector name=" + chr(34) + "sun_direction" + chr(34), (rng.uniform(-1, 1), rng.uniform(0.3, 1), rng.uniform(-1, 1)))}</emitter>',
                lambda: f'<emitter type="directional">{vector("vector name=" + chr(34) + "direction" + chr(34), (rng.uniform(-1, 1), -1, rng.uniform(-1, 1)))}'
                f'{rgb("irradiance", self.colour(1, 3))}</emitter><emitter type="constant">{rgb("radiance", self.colour(0.1, 0.5))}</emitter>',
            ])())

    def room(self, size):
        """A box of thin walls that are seen from both sides, with an open side through which the sky is seen, or without."""
        w, h, d = size
        window = self.rng.random() < 0.35
        walls = {'x-': (0, h / 2, d / 2, 'y', 90, d, h), 'x+': (w, h / 2, d / 2, 'y', -90, d, h), 'z-': (w / 2, h / 2, 0, 'y', 0, w, h),
                 'z+': (w / 2, h / 2, d, 'y', 180, w, h), 'y-': (w / 2, 0, d / 2, 'x', -90, w, d), 'y+': (w / 2, h, d / 2, 'x', 90, w, d)}
        for side, (x, y, z, axis, angle, a, b) in walls.items():
            if window and side == 'x+':
                continue
            body = place(f'<scale x="{a / 2:.5g}" y="{b / 2:.5g}"/>', f'<rotate {axis}="1" angle="{angle}"/>', f'<translate x="{x:.5g}" y="{y:.5g}" z="{z:.5g}"/>')
            self.parts.append(f'<shape type="rectangle">{body}{self.material(clear=False)}</shape>')
        return window

    def sensor(self, eye, target, unit):
        rng = self.rng
        kind = rng.choice(['perspective', 'perspective', 'perspective', 'thinlens', 'orthographic'])
        look = f'<lookat origin="{eye[0]:.5g}, {eye[1]:.5g}, {eye[2]:.5g}" target="{target[0]:.5g}, {target[1]:.5g}, {target[2]:.5g}" up="0, 1, 0"/>'
        body = number('fov', rng.uniform(35, 80)) if kind != 'orthographic' else ''
        if kind == 'thinlens':
            distance = sum((a - b)**2 for a, b in zip(eye, target))**0.5
            body += number('aperture_radius', 0.02 * distance) + number('focus_distance', distance)
        scale = f'<scale value="{unit * rng.uniform(0.5, 1.2):.4g}"/>' if kind == 'orthographic' else ''
        return (f'<sensor type="{kind}">{body}{place(scale, look)}<film type="hdrfilm"><integer name="width" value="{SIZE[0]}"/>'
                f'<integer name="height" value="{SIZE[1]}"/><rfilter type="{rng.choice(["box", "gaussian", "tent"])}"/></film></sensor>')

    def make(self):
        rng = self.rng
        unit = 10**rng.choice([0, 0, 0, -2, 2])
        if rng.random() < 0.6:
            size = [unit * rng.uniform(2, 5), unit * rng.uniform(2, 3.5), unit * rng.uniform(2, 5)]
            if self.room(size):
                self.sky()
            eye = [rng.uniform(0.1, 0.35) * size[0], rng.uniform(0.3, 0.7) * size[1], rng.uniform(0.1, 0.3) * size[2]]
            target = [rng.uniform(0.5, 0.8) * size[0], rng.uniform(0.1, 0.4) * size[1], rng.uniform(0.6, 0.9) * size[2]]
            power = 0.3 * size[0] * size[2]
            spots, lamps = [[rng.uniform(0.35, 0.85) * size[0], 0, rng.uniform(0.4, 0.85) * size[2]] for _ in range(rng.randint(1, 5))], rng.randint(1, 3)
            high = 0.92 * size[1]
            area = size
        else:
            side = unit * rng.choice([4, 4, 40, 4000])
            self.parts.append(f'<shape type="rectangle">{place(f"<scale value={chr(34)}{side:.5g}{chr(34)}/>", "<rotate x=" + chr(34) + "1" + chr(34) + " angle=" + chr(34) + "-90" + chr(34) + "/>")}'
                              f'{self.material(clear=False)}</shape>')
            eye, target = [unit * rng.uniform(-2, 2), unit * rng.uniform(0.6, 2), unit * 3], [0, 0.3 * unit, 0]
            power, high, area = 3 * unit**2, 2.5 * unit, [2 * unit] * 3
            spots = [[unit * rng.uniform(-1.2, 1.2), 0, unit * rng.uniform(-1.2, 1)] for _ in range(rng.randint(1, 5))]
            lamps = rng.randint(0, 2)
            if not lamps or rng.random() < 0.6:
                self.sky()
        sensor = self.sensor(eye, target, unit)
        for at in spots:
            self.thing(at, unit * 10**rng.uniform(-1, -0.3))
        for _ in range(lamps):
            at = [rng.uniform(0.2, 0.8) * area[0], high, rng.uniform(0.2, 0.8) * area[2]]
            aim = [a + rng.uniform(-0.3, 0.3) * unit for a in (at[0], 0, at[2])]
            self.lamp(at, aim, power / max(lamps, 1), unit)
        return sensor


def write(file, sensor, parts):
    body = '\n'.join([sensor, *parts])
    file.write_text(f'<scene version="3.0.0">\n<integrator type="path"><integer name="max_depth" value="-1"/></integrator>\n{body}\n</scene>\n')
    return file


def shrink(trust, name, sensor, parts):
    """Leaves out parts one after the other while the scene stays off."""
    left, tries = list(parts), 0
    for part in parts:
        fewer, tries = [p for p in left if p is not part], tries + 1
        off = trust.off
        trust.measure(f'{name}-try-{tries}', write(trust.folder / f'{name}-try-{tries}.xml', sensor, fewer))
        if trust.off > off:
            left, trust.off = fewer, off
    write(trust.folder / f'{name}-small.xml', sensor, left)
    print(f'{name}: {len(left)} of {len(parts)} parts are enough, {name}-small.xml')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('pencil')
    parser.add_argument('--count', type=int, default=10)
    parser.add_argument('--seed', type=int, default=random.SystemRandom().randrange(1 << 30))
    parser.add_argument('--keep')
    parser.add_argument('--reference-time', type=float, default=15)
    parser.add_argument('--limit', type=float, default=60)
    parser.add_argument('--shrink', action='store_true')
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.keep or tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    trust = Trust(arguments, folder, ['--allow', SCENES])
    print('| scene | mean ratio | true relMSE | estimated | seconds |\n|---|---|---|---|---|')
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        maker, off, name = Maker(seed), trust.off, f'scene-{seed}'
        sensor = maker.make()
        trust.measure(name, write(folder / f'{name}.xml', sensor, maker.parts))
        if arguments.shrink and trust.off > off:
            shrink(trust, name, sensor, maker.parts)
    print(f'{trust.count} scenes: {trust.off} off by more than 1 % and three standard errors, {trust.low} with more than twice the claimed error, '
          f'{trust.endless} without end; seed {arguments.seed}, files in {folder}')
    return 1 if trust.off or trust.endless else 0


if __name__ == '__main__':
    sys.exit(main())
