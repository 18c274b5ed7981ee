#!/usr/bin/env python3
"""make_trust_scenes.py: writes scenes/trust/, small scenes on which renderers that reuse light go wrong. Each says in a comment what it is hard for; the truth is
`pencil reference` with many paths (scripts/trust.py), or a closed form that the comment gives. Only rooms, boxes and two meshes: what matters is written out."""
import math
import pathlib
import struct

OUT = pathlib.Path(__file__).resolve().parent.parent / 'scenes' / 'trust'


def diffuse(*colour):
    return f'<bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value="{", ".join(f"{c:g}" for c in colour)}"/></bsdf></bsdf>'


BLACK = diffuse(0)
PLASTER, RED, BLUE, WOOD, EARTH = diffuse(0.8), diffuse(0.7, 0.2, 0.15), diffuse(0.2, 0.3, 0.7), diffuse(0.6, 0.4, 0.25), diffuse(0.4, 0.35, 0.3)


def emitter(*radiance):
    return f'<emitter type="area"><rgb name="radiance" value="{", ".join(str(r) for r in radiance)}"/></emitter>'


def placed(kind, scale, move, content, turn=''):
    x, y, z = scale
    return (f'    <shape type="{kind}">\n        <transform name="to_world"><scale x="{x}" y="{y}" z="{z}"/>{turn}'
            f'<translate x="{move[0]}" y="{move[1]}" z="{move[2]}"/></transform>\n        {content}\n    </shape>\n')


def box(low, high, material):
    half = [f'{(b - a) / 2:g}' for a, b in zip(low, high)]
    return placed('cube', half, [f'{(a + b) / 2:g}' for a, b in zip(low, high)], material)


def ball(centre, radius, content, inside=False):
    flip = '<boolean name="flip_normals" value="true"/>' if inside else ''
    return (f'    <shape type="sphere">\n        <float name="radius" value="{radius}"/>'
            f'<point name="center" x="{centre[0]}" y="{centre[1]}" z="{centre[2]}"/>{flip}\n        {content}\n    </shape>\n')


def floor_like(half_x, half_z, at, content, up):
    """A rectangle of 2 half_x by 2 half_z that faces up or down."""
    return placed('rectangle', (half_x, half_z, 1), at, content, f'<rotate x="1" angle="{-90 if up else 90}"/>')


def mesh(name, content):
    return f'    <shape type="ply">\n        <string name="filename" value="{name}"/>\n        {content}\n    </shape>\n'


def sky(radius, radiance):
    return ball((0, 0, 0), radius, BLACK + emitter(radiance), inside=True)


def scene(name, comment, eye, target, body, fov=70, defaults=(), clip=''):
    given = ''.join(f'    <default name="{key}" value="{value}"/>\n' for key, value in (*defaults, ('width', 96), ('height', 72)))
    lines = '\n     '.join(comment.split('\n'))
    (OUT / f'{name}.xml').write_text(f'''<?xml version="1.0" encoding="utf-8"?>
<!-- {lines} -->
<scene version="3.0.0">
{given}
    <integrator type="path"><integer name="max_depth" value="-1"/></integrator>
    <sensor type="perspective">
        <float name="fov" value="{fov}"/>{clip}
        <transform name="to_world"><lookat origin="{', '.join(map(str, eye))}" target="{', '.join(map(str, target))}" up="0, 1, 0"/></transform>
        <film type="hdrfilm">
            <integer name="width" value="$width"/>
            <integer name="height" value="$height"/>
            <rfilter type="box"/>
        </film>
    </sensor>

{body}</scene>
''')


def write_ply(name, vertices, triangles):
    header = (f'ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n'
              f'element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n')
    data = b''.join(struct.pack('<3f', *v) for v in vertices) + b''.join(struct.pack('<B3i', 3, *t) for t in triangles)
    (OUT / f'{name}.ply').write_bytes(header.encode() + data)


def room(t, low, high, material=PLASTER, open_sides=()):
    """Walls of thickness t around a room; sides in open_sides ('x-', 'x+' ...) are left out."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    walls = {'y-': ((x0 - t, y0 - t, z0 - t), (x1 + t, y0, z1 + t)), 'y+': ((x0 - t, y1, z0 - t), (x1 + t, y1 + t, z1 + t)),
             'x-': ((x0 - t, y0, z0 - t), (x0, y1, z1 + t)), 'x+': ((x1, y0, z0 - t), (x1 + t, y1, z1 + t)),
             'z-': ((x0, y0, z0 - t), (x1, y1, z0)), 'z+': ((x0, y0, z1), (x1, y1, z1 + t))}
    return ''.join(box(*walls[side], material) for side in walls if side not in open_sides)


def wall_with_hole(x, t, z0, z1, height, hole, material):
    """A wall at x .. x + t from z0 to z1; hole: (from z, to z, from y, to y)."""
    a, b, low, high = hole
    parts = [((x, 0, z0), (x + t, height, a)), ((x, 0, b), (x + t, height, z1)), ((x, high, a), (x + t, height, b))]
    if low > 0:
        parts.append(((x, 0, a), (x + t, low, b)))
    return ''.join(box(low_corner, high_corner, material) for low_corner, high_corner in parts)


def outdoor_rooms():
    for name, t in (('outdoor-rooms', 0.2), ('outdoor-sheets', 0.004)):
        body = (sky(60, 10) + box((-50, -t - 0.4, -50), (50, -t, 50), EARTH) + room(t, (0, 0, 0), (8, 3, 5), open_sides=('x-', )) +
                wall_with_hole(-t, t, -t, 5 + t, 3, (1.5, 2.5, 0, 2.2), PLASTER) + wall_with_hole(4, t, 0, 5, 3, (2.5, 3.4, 0, 2.1), RED) +
                box((5, 0, 0.2), (6.5, 0.75, 1), WOOD) + box((1, 0, 4), (1.5, 1.6, 4.8), BLUE))
        scene(name, f'Two rooms in a bright open: light enters by one doorway, and by a second one the room that is seen; walls of {t} m.\n'
              'Hard: the ground outside is some hundred times brighter than the floor within, at the same level.', (7.5, 1.6, 4.5), (3, 1, 2), body)


def tunnel():
    body = (sky(200, 5) + box((-100, -0.7, -100), (100, -0.3, 100), EARTH) + room(0.3, (0, 0, 0), (3, 2.5, 14), open_sides=('z+', )) +
            box((1, 0, 5), (2, 1, 6), RED))
    scene('tunnel', 'A passage, closed at one end, open to a bright sky at the other; the camera looks in from the mouth.\n'
          'Hard: light falls by a thousand from end to end.', (1.5, 1.3, 13), (1.5, 1, 0), body)


def ground_plane():
    body = (floor_like('$extent', '$extent', (0, 0, 0), EARTH, True) + ball((0, 40, 0), 8, BLACK + emitter(60)) + box((-1, 0, -1), (0, 1.2, 0), RED) +
            box((0.3, 0, -0.6), (1.2, 0.5, 0.4), PLASTER) + ball((0.4, 0.35, 1.1), 0.35, BLUE) + box((-1.6, 0, 0.6), (-1, 0.15, 1.6), PLASTER))
    scene('ground-plane', 'Things on a ground of 2 extent x 2 extent, seen from near; -D extent=1e2, 1e4, 1e6.\n'
          'Hard: what matters is a millionth of the extent. The image hardly depends on it.', (2.6, 1.7, 3), (-0.1, 0.3, 0), body, 50,
          (('extent', 100), ), '<float name="far_clip" value="1e9"/>')


def far_light():
    body = (room(0.1, (-2, 0, -2), (2, 2.4, 2), open_sides=('x+', )) + wall_with_hole(2, 0.1, -2.1, 2.1, 2.4, (-1, 1, 0.8, 2), PLASTER) +
            box((-1.5, 0, -1.5), (-0.7, 1, -0.6), RED) + ball((0, 0.4, -0.4), 0.4, BLUE) +
            placed('rectangle', ('$size', '$size', 1), ('$distance', '$distance', 0), BLACK + emitter(40),
                   '<rotate y="1" angle="-90"/><rotate z="1" angle="45"/>'))
    scene('far-light', 'A room lit through a window by a lamp $distance away, of half its distance in width; -D distance=10 -D size=2.5, up to 1e6 and\n'
          '2.5e5. Hard: the extent of the scene says nothing of the room. The image hardly depends on it.', (-1.6, 1.5, 1.6), (0.6, 0.9, -0.8), body, 75,
          (('distance', 10), ('size', 2.5)), '<float name="far_clip" value="1e9"/>')


def relief():
    n = 40
    height = lambda x, z: 0.06 * abs(math.sin(23 * x) * math.sin(19 * z)) + 0.03 * math.sin(61 * x + 2 * math.sin(9 * z))
    points = [(2 * i / n - 1, 2 * k / n - 1) for k in range(n + 1) for i in range(n + 1)]
    cells = [(k * (n + 1) + i, k * (n + 1) + i + 1, (k + 1) * (n + 1) + i) for k in range(n) for i in range(n)]
    write_ply('relief', [(x, height(x, z), z) for x, z in points], [t for a, b, c in cells for t in ((a, c, b), (b, c, c + 1))])
    body = mesh('relief.ply', PLASTER) + ball((0, 1.3, 0), 0.7, BLACK + emitter(3, 2.6, 2.2)) + floor_like(4, 4, (0, -0.3, 0), WOOD, True)
    scene('relief', 'A rough ground under a large lamp. Hard: direct light changes from face to face; nothing may be reused across them.', (1.2, 1, 1.6),
          (0, 0, 0), body, 50)


def thin_lamp():
    turns, around = 720, 4
    vertices, triangles = [], []
    for k in range(turns):
        a = 2 * math.pi * k / turns
        for j in range(around):
            b = 2 * math.pi * j / around
            r = 0.9 + 0.004 * math.cos(b)
            vertices.append((r * math.cos(a), 0.004 * math.sin(b) + 0.05 * math.sin(9 * a), r * math.sin(a)))
    for k in range(turns):
        for j in range(around):
            a, b, c, d = (k * around + j, k * around + (j + 1) % around, (k + 1) % turns * around + j, (k + 1) % turns * around + (j + 1) % around)
            triangles += [(a, b, c), (b, d, c)]
    write_ply('ring', vertices, triangles)
    lamp = mesh('ring.ply', '<transform name="to_world"><translate x="0" y="1.9" z="0"/></transform>' + BLACK + emitter(200, 180, 150))
    body = room(0.1, (-1.6, 0, -2), (1.6, 2.4, 2)) + box((-1.2, 0, -1.5), (-0.4, 1.1, -0.8), RED) + ball((0.5, 0.4, -0.6), 0.4, BLUE) + lamp
    scene('thin-lamp', 'A room under a ring of wire that glows, of 5760 triangles. Hard: many small emitters; seeds must agree.', (1.3, 1.5, 1.8), (-0.2, 0.8, -1),
          body, 75)


def cove():
    body = (room(0.1, (-2, 0, -2), (2, 2.4, 2), diffuse(0.75)) + box((-1.9, 2.05, -2), (1.9, 2.1, -1.75), PLASTER) + box((-1.9, 2.1, -1.78), (1.9, 2.2, -1.75), PLASTER) +
            floor_like(1.7, 0.02, (0, 2.11, -1.9), BLACK + emitter(400, 360, 300), True) + box((-1.2, 0, -1.2), (-0.5, 0.9, -0.5), RED) + ball((0.6, 0.35, 0), 0.35, BLUE))
    scene('cove', 'A lamp on a ledge shines at the ceiling, 30 cm above it; nothing else is lit by it. Hard: all light is reflected at one bright stripe.',
          (1.5, 1.3, 1.8), (-0.3, 1, -1), body, 80)


def uplight():
    body = (room(0.01, (-2, 0, -2), (2, 2.4, 2), diffuse(0.6)) + floor_like(0.25, 0.25, (0.2, 2.28, -0.4), BLACK + emitter(300, 360, 330), True) +
            box((-1.2, 0, -1.2), (-0.5, 0.9, -0.5), RED) + ball((0.6, 0.35, 0), 0.35, BLUE))
    scene('uplight', 'A small lamp shines up at the ceiling, 12 cm above it. Hard: all light comes from a spot of the ceiling as wide as the lamp, which hides most of it.',
          (1.5, 1.3, 1.8), (-0.3, 0.8, -1), body, 60)


def bulb(x, y, z, intensity):
    return (f'    <emitter type="point"><point name="position" x="{x}" y="{y}" z="{z}"/><rgb name="intensity" value="{intensity}"/></emitter>\n')


def wall_lamps():
    body = (room(0.1, (-2, 0, -2), (2, 2.4, 2), diffuse(0.65)) + box((-0.4, 0, -0.2), (0.4, 1.2, 0.6), BLUE) + bulb(-1.97, 1.9, -1, '1, 0.9, 0.8') +
            bulb(0.2, 2.38, -1.7, '0.4, 0.4, 0.44'))
    scene('wall-lamps', 'Two bulbs, 3 cm before a wall and 2 cm under the ceiling. Hard: half of the light of each is reflected by a spot as small as a plate.',
          (1.6, 1.5, 1.5), (-0.2, 1, -0.5), body, 70)


def ceiling_lamp():
    body = (room(0.1, (-2, 0, -2), (2, 2.4, 2), diffuse(0.8)) + box((-1.2, 0, -1.2), (-0.5, 0.9, -0.5), RED) +
            ball((0.3, 2.365, -0.8), 0.03, BLACK + emitter(600, 560, 500)))
    scene('ceiling-lamp', 'A lamp as large as a walnut, 5 mm under the ceiling, in view. Hard: it is smaller than a pixel, and half of its light\n'
          'is reflected by a spot of the ceiling as small as a hand, which few rays find.', (1.6, 1.2, 1.8), (-0.1, 1.7, -1), body, 75)


def maze():
    walls = ''.join(wall_with_hole(2 * k, 0.1, 0, 3, 2.4, (0.2, 0.9, 0, 2) if k % 2 else (2.1, 2.8, 0, 2), PLASTER if k % 3 else RED) for k in range(1, 10))
    body = (room(0.1, (0, 0, 0), (20, 2.4, 3)) + walls + floor_like(0.3, 0.3, (1, 2.38, 1.5), BLACK + emitter(300), False) +
            ''.join(box((2 * k + 0.7, 0, 1.2), (2 * k + 1.3, 0.8, 1.6), WOOD if k % 2 else BLUE) for k in range(1, 10)))
    scene('maze', 'Ten rooms in a row, their doors at alternating ends; the lamp hangs in the first, the camera stands in the fifth.\n'
          'Hard: ten orders of reflection before the first light arrives; each room has a small part of the light of the last.', (9.7, 1.5, 2.6), (8.3, 1, 0.6), body, 80)


def coincident():
    walls = room(0.1, (-2, 0, -2), (2, 2.4, 2))
    body = walls + walls + box((-1.2, 0, -1.2), (-0.4, 1, -0.5), RED) * 2 + ball((0.6, 0.4, 0), 0.4, BLUE) + floor_like(0.3, 0.3, (0.3, 2.37, 0), BLACK + emitter(20), False)
    scene('coincident', 'Every wall twice, in the same place. Hard: rays that leave one must not meet the other.', (1.6, 1.4, 1.8), (-0.3, 0.9, -1), body, 75)


def bright_room():
    white = diffuse(0).replace('"0"', '"$albedo"')
    body = room(0.1, (-2, 0, -2), (2, 2.4, 2), white) + floor_like(0.3, 0.3, (0.3, 2.37, 0), BLACK + emitter(2), False)
    scene('bright-room', 'A closed room of walls of one albedo, empty, with a small lamp; -D albedo=0.97, 0.99.\n'
          'Hard: what is lost in one reflection is lost a hundred times. The walls absorb in the mean what the lamp emits.', (1.6, 1.4, 1.8), (-0.3, 0.9, -1), body, 75,
          (('albedo', 0.9), ))


def contacts():
    body = (room(0.1, (-2, 0, -2), (2, 2.4, 2)) + floor_like(0.35, 0.35, (0.2, 2.38, 0.3), BLACK + emitter(15), False) + box((-1.5, 0.003, -1.5), (-0.6, 0.9, -0.7), RED) +
            box((-0.3, 0.05, -1.2), (0.5, 0.1, -0.2), WOOD) + ball((0.9, 0.3, -0.9), 0.3, BLUE) + ball((-1.998, 1.2, -0.2), 0.06, diffuse(0.9)) +
            box((0.2, 1.2, -2), (1.2, 1.24, -1.75), WOOD) + box((0.4, 1.24, -1.95), (0.45, 1.5, -1.8), RED) + box((0.46, 1.24, -1.95), (0.5, 1.46, -1.8), BLUE))
    scene('contacts', 'Things that hang a little above the floor, stand close, touch in a point. Hard: light changes within a millimetre of contacts.', (1.4, 1.2, 1.7),
          (-0.2, 0.6, -1), body, 65)


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    for make in (outdoor_rooms, tunnel, ground_plane, far_light, relief, thin_lamp, cove, uplight, wall_lamps, ceiling_lamp, maze, coincident, bright_room, contacts):
        make()


if __name__ == '__main__':
    main()
