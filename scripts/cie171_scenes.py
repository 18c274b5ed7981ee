"""Scenes, sensors and expected values of cie171.py. Metres, z up, photometric units: radiance is luminance [cd m^-2], intensity candela."""
import math

GLASS = 1.52  # index of refraction


class Case:
    """One scene. expected: [(point, value)]; a case with `meters` means over all of them, weighted by area."""

    def __init__(self, number, name, scene, sensors, expected, lumens=1.0, column='illuminance', areas=()):
        self.number, self.name, self.scene, self.sensors, self.expected = number, name, scene, sensors, expected
        self.lumens, self.column, self.areas = lumens, column, areas

    def results(self, rows):
        """(point and expected value, measured, ends of its interval) of each point."""
        if self.areas:
            total = [sum(a * row[k] for a, row in zip(self.areas, rows)) for k in ('illuminance', 'low', 'high')]
            return [(self.expected[0], *total)]
        spread = [(row['low'] - row['illuminance'], row['high'] - row['illuminance']) for row in rows]
        return [(e, row[self.column], row[self.column] + low, row[self.column] + high)
                for e, row, (low, high) in zip(self.expected, rows, spread)]


# Closed forms.


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def configuration_factor(at, normal, corners):
    """Of a point to a polygon, by Lambert's formula: the sum over the edges of angle times normal of the plane through eye and edge. The part
    below the horizon of the point is cut off."""
    visible, around = [], list(zip(corners, corners[1:] + corners[:1]))
    for a, b in around:
        ha, hb = dot(sub(a, at), normal), dot(sub(b, at), normal)
        if ha >= 0:
            visible.append(a)
        if ha * hb < 0:
            visible.append([x + ha / (ha - hb) * (y - x) for x, y in zip(a, b)])
    total = 0
    for a, b in zip(visible, visible[1:] + visible[:1]):
        u, v = unit(sub(a, at)), unit(sub(b, at))
        across = cross(u, v)
        length = math.sqrt(dot(across, across))
        if length > 1e-15:
            total += math.atan2(length, dot(u, v)) * dot(across, normal) / length
    return abs(total) / (2 * math.pi)


def reflectances(cosine, index):
    """Fresnel's, across and along the plane of incidence."""
    refracted = math.sqrt(1 - (1 - cosine**2) / index**2)
    return ((cosine - index * refracted) / (cosine + index * refracted))**2, ((index * cosine - refracted) / (index * cosine + refracted))**2


def pane(reflectance):
    """Transmittance of two faces and all reflections between them."""
    return (1 - reflectance) / (1 + reflectance)


# Parts of scenes.


def rectangle(corner, u, v, inner):
    centre = [c + (a + b) / 2 for c, a, b in zip(corner, u, v)]
    normal = unit(cross(u, v))
    rows = ' '.join(f'{a / 2!r} {b / 2!r} {n!r} {c!r}' for a, b, n, c in zip(u, v, normal, centre))
    return f'<shape type="rectangle"><transform name="to_world"><matrix value="{rows} 0 0 0 1"/></transform>{inner}</shape>\n'


def diffuse(albedo):
    return f'<bsdf type="diffuse"><rgb name="reflectance" value="{albedo!r}"/></bsdf>'


def lamp(luminance):
    return diffuse(0.0) + f'<emitter type="area"><rgb name="radiance" value="{luminance!r}"/></emitter>'


def meter(name):
    return f'<sensor type="irradiancemeter" id="{name}"/>'


def point_light(at, candela):
    return f'<emitter type="point"><point name="position" value="{at[0]}, {at[1]}, {at[2]}"/><rgb name="intensity" value="{candela!r}"/></emitter>\n'


def sun(direction, lux):
    x, y, z = direction
    return (f'<emitter type="directional"><vector name="direction" value="{x!r}, {y!r}, {z!r}"/>'
            f'<rgb name="irradiance" value="{lux!r}"/></emitter>\n')


def scene(body):
    return ('<scene version="3.0.0">\n<integrator type="path"/>\n<sensor type="perspective"><transform name="to_world">'
            '<lookat origin="2, 2, 1" target="2, 4, 1" up="0, 0, 1"/></transform></sensor>\n' + body + '</scene>\n')


def room(width, depth, height, inner, ceiling=True):
    """Its surfaces looking inwards, and their areas; inner(name): what they are."""
    sides = [('floor', (0, 0, 0), (width, 0, 0), (0, depth, 0)), ('south', (0, 0, 0), (0, 0, height), (width, 0, 0)),
             ('north', (0, depth, 0), (width, 0, 0), (0, 0, height)), ('west', (0, 0, 0), (0, depth, 0), (0, 0, height)),
             ('east', (width, 0, 0), (0, 0, height), (0, depth, 0))]
    if ceiling:
        sides.append(('ceiling', (0, 0, height), (0, depth, 0), (width, 0, 0)))
    areas = [math.sqrt(dot(cross(u, v), cross(u, v))) for _, _, u, v in sides]
    return ''.join(rectangle(corner, u, v, inner(name)) for name, corner, u, v in sides), areas


# The cases.


def point_sources(folder):
    """5.2: 3 m over a black floor of 4 m x 4 m: an isotropic source, and a diffuse one from a photometric file."""
    places = [(0, 0), (0.5, 0), (1, 0), (1.5, 0), (0.5, 0.5), (1, 0.5), (1.5, 0.5), (1, 1), (1.5, 1), (1.5, 1.5)]
    sensors = [(label, (2 + x, 2 + y, 0), (0, 0, 1)) for label, (x, y) in zip('ABCDEFGHIJ', places)]
    floor = rectangle((0, 0, 0), (4, 0, 0), (0, 4, 0), diffuse(0.0))
    cosines = [3 / math.sqrt(9 + x * x + y * y) for x, y in places]
    angles = range(91)
    numbers = ' '.join(str(a) for a in angles) + '\n0\n' + ' '.join(repr(1000 * math.cos(math.radians(a))) for a in angles)
    (folder / 'diffuse.ies').write_text(f'IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 91 1 1 2 0 0 0\n1 1 0\n{numbers}\n')
    file = ('<emitter type="ies"><string name="filename" value="diffuse.ies"/><transform name="to_world">'
            '<rotate x="1" angle="180"/><translate x="2" y="2" z="3"/></transform></emitter>\n')
    label = [s[0] for s in sensors]
    yield Case('5.2', 'isotropic', scene(floor + point_light((2, 2, 3), 1000)), sensors, list(zip(label, [1000 * c**3 / 9 for c in cosines])))
    yield Case('5.2', 'diffuse file', scene(floor + file), sensors, list(zip(label, [1000 * c**4 / 9 for c in cosines])), 683.0)


def area_source(_):
    """5.3: a diffuse source of 1 m x 1 m, 1000 cd, in the ceiling of a black room of 4 m x 4 m x 3 m."""
    corners = [[1.5, 1.5, 3], [1.5, 2.5, 3], [2.5, 2.5, 3], [2.5, 1.5, 3]]
    sensors = [(label, (2, 0, 2.75 - 0.5 * i), (0, 1, 0)) for i, label in enumerate('ABCDEF')]
    sensors += [(label, (2, 0.25 + 0.5 * i, 0), (0, 0, 1)) for i, label in enumerate('GHIJKLMN')]
    body = room(4, 4, 3, lambda _: diffuse(0.0), ceiling=False)[0] + rectangle((1.5, 1.5, 3), (0, 1, 0), (1, 0, 0), lamp(1000.0))
    expected = [(label, math.pi * 1000 * configuration_factor(at, normal, corners)) for label, at, normal in sensors]
    yield Case('5.3', 'area source', scene(body), sensors, expected)


def flux(_):
    """5.4: what a source emits, or comes in through an opening in the roof under an even sky, arrives on the surfaces of a black room of
    4 m x 4 m x 3 m."""
    body, areas = room(4, 4, 3, lambda name: diffuse(0.0) + meter(name))
    yield Case('5.4', 'source of 10 000 lm', scene(body + point_light((2, 2, 1.5), 10000 / (4 * math.pi))), [], [('flux', 10000)], areas=areas)
    body, areas = room(4, 4, 3, lambda name: diffuse(0.0) + meter(name), ceiling=False)
    for side in (1, 2, 3, 4):
        low = 2 - side / 2
        opening = rectangle((low, low, 3), (0, side, 0), (side, 0, 0), lamp(1000.0))
        yield Case('5.4', f'opening {side} m x {side} m', scene(body + opening), [], [('flux', 1000 * math.pi * side * side)], areas=areas)


def clear_glass(_):
    """5.5: parallel light through a pane of index 1.52 that absorbs nothing. The standard's own glass is not modelled. Both faces reflect
    unpolarised light: in truth the first leaves it polarised, and 1.5 % more passes at 60 degrees."""
    sensor = [('behind', (0, 0, 0), (0, 0, 1))]
    glass = '<bsdf type="thindielectric"><float name="int_ior" value="1.52"/><float name="ext_ior" value="1"/></bsdf>'
    for degrees in (0, 10, 20, 30, 40, 50, 60, 70, 80):
        angle = math.radians(degrees)
        body = rectangle((-50, -50, 1), (100, 0, 0), (0, 100, 0), glass) + sun((math.sin(angle), 0.0, -math.cos(angle)), 10000.0)
        across, along = reflectances(math.cos(angle), GLASS)
        expected = 10000 * math.cos(angle) * pane((across + along) / 2)
        yield Case('5.5', 'pane', scene(body), sensor, [(f'{degrees} degrees', expected)])


def diffuse_reflection(_):
    """5.6: a horizontal surface S2, lit evenly, lights a vertical and a horizontal surface, 2 m and 3 m from its middle. The points are those
    published for 4 m x 4 m, for all three sizes."""
    albedo, lux = 0.3, 10000.0
    sensors = [(label, (2, 0, 0.75 + 0.5 * i), (0, 1, 0)) for i, label in enumerate('BCDEF')]
    sensors += [(label, (2, 0.25 + 0.5 * i, 3), (0, 0, -1)) for i, label in enumerate('GHIJKLMN')]
    for side in (0.5, 4.0, 500.0):
        low, high = 2 - side / 2, 2 + side / 2
        body = rectangle((low, low, 0), (side, 0, 0), (0, side, 0), diffuse(albedo)) + sun((0.0, 0.0, -1.0), lux)
        corners = [[low, low, 0], [high, low, 0], [high, high, 0], [low, high, 0]]
        expected = [(label, albedo * lux * configuration_factor(at, normal, corners)) for label, at, normal in sensors]
        yield Case('5.6', f'S2 {side:g} m x {side:g} m', scene(body), sensors, expected)


def obstruction(_):
    """5.7: a wall S2 of 4 m x 3 m, lit by a sun 60 degrees high, lights the wall opposite and the floor over a black block, 1 m high, from
    y = 2.5 m to 2.7 m. Of the floor the indirect part is measured. Seen from the middle the block hides S2 up to a height."""
    albedo, lux = 0.6, 10000.0
    sensors = [(label, (2, 0, 2.75 - 0.5 * i), (0, 1, 0)) for i, label in enumerate('ABCDEF')]
    sensors += [(label, (2, 0.25 + 0.5 * i, 0), (0, 0, 1)) for i, label in enumerate('GHIJK')]
    body = rectangle((0, 4, 0), (4, 0, 0), (0, 0, 3), diffuse(albedo)) + rectangle((0, 0, 0), (0, 0, 3), (4, 0, 0), diffuse(0.0))
    body += rectangle((0, 0, 0), (4, 0, 0), (0, 2.5, 0), diffuse(0.0))
    body += ('<shape type="cube"><transform name="to_world"><scale x="2" y="0.1" z="0.5"/><translate x="2" y="2.6" z="0.5"/></transform>'
             + diffuse(0.0) + '</shape>\n')
    tilt = math.radians(60)
    body += sun((0.0, math.cos(tilt), -math.sin(tilt)), lux)
    expected = []
    for label, at, normal in sensors:
        hidden = max(at[2] + (1 - at[2]) * (4 - at[1]) / (y - at[1]) for y in (2.5, 2.7))
        low = min(max(hidden, 0), 3)
        corners = [[0, 4, low], [4, 4, low], [4, 4, 3], [0, 4, 3]]
        factor = configuration_factor(at, normal, corners) if low < 3 else 0
        expected.append((label, albedo * lux * math.cos(tilt) * factor))
    yield Case('5.7', 'obstruction', scene(body), sensors, expected, column='indirect')


def reflected_component(_):
    """5.8: a source of 10 000 lm in the middle of a cube of 4 m whose walls have one albedo: mean illuminance by energy balance."""
    for albedo in (0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95):
        body, areas = room(4, 4, 4, lambda name, a=albedo: diffuse(a) + meter(name))
        total = sum(areas)
        yield Case('5.8', f'albedo {albedo:g}', scene(body + point_light((2, 2, 2), 10000 / (4 * math.pi))), [],
                   [('mean', 10000 / (total * (1 - albedo)))], areas=[a / total for a in areas])


def cases(folder):
    for group in (point_sources, area_source, flux, clear_glass, diffuse_reflection, obstruction, reflected_component):
        yield from group(folder)
