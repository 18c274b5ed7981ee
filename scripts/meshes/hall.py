"""Meshes of colonnade.xml [m]. The hall runs along z from 3.2 to -22.4 in eight bays of 3.2; a column stands at every bay's end but the
outermost. All have normals, so that shafts, arches and the vault are smooth."""
import math

from meshes.mesh import Mesh
from meshes.shapes import arch_points, arched_panel, arched_reveal, box, even, flat, lathe, patch, spline

BAY, BAYS = 3.2, 8
FIRST, LAST = 3.2, 3.2 - BAY * BAYS
CAPITAL, SPRING = 4.5, 4.48  # top of the abacus; the arches stand 2 cm in it
ARCH, TOP = 1.12, 6.3  # radius of the arches; top of arcade and aisles
DEPTH = 0.70  # thickness of the arcade
NAVE = 2.8 - DEPTH / 2  # half the width between the arcades
AISLE = 5.8


def turned(point):
    """From the plane of a panel (x, y, z) to a wall along the hall that faces +x: panel x becomes -z."""
    x, y, z = point
    return (z, y, -x)


def column():
    """Base, shaft of 24 flutes, capital; 0.96 square at foot and head, 4.5 high, its axis the y axis."""
    low, high, flutes = 0.42, 4.10, 24

    def radius(y):
        t = max(0.0, y - low) / (high - low)
        return 0.36 - 0.06 * t**1.6  # entasis

    def shaft(flute):
        def point(s, y):
            fade = min(1.0, max(0.0, min(y - low, high - y) / 0.12))
            r = radius(y) - 0.034 * math.sqrt(fade * (2.0 - fade)) * 4.0 * s * (1.0 - s)
            angle = 2 * math.pi * (flute + s) / flutes
            return (r * math.sin(angle), y, r * math.cos(angle))
        return point

    mesh = flat(box((-0.48, -0.01, -0.48), (0.48, 0.14, 0.48)))
    torus, fillet = spline([(0.44, 0.135), (0.475, 0.165), (0.475, 0.205), (0.44, 0.235)], 3), [(0.44, 0.235), (0.40, 0.235), (0.40, 0.25)]
    scotia = spline([(0.40, 0.25), (0.375, 0.28), (0.39, 0.315)], 2)
    ring = spline([(0.39, 0.315), (0.415, 0.335), (0.415, 0.36), (0.39, 0.38)], 2)
    foot = spline([(0.385, 0.38), (0.365, 0.395), (0.36, low)], 2)
    mesh.add(lathe([torus, fillet, scotia, ring, foot], 32))
    rows = [low - 0.015, low, low + 0.015, low + 0.05] + even(low + 0.12, high - 0.12, 6) + [high - 0.05, high - 0.015, high, high + 0.02]
    for flute in range(flutes):  # its ends lie in base and capital
        mesh.add(patch(shaft(flute), even(0.0, 1.0, 4), rows))
    bead = spline([(0.295, high + 0.005), (0.33, high + 0.03), (0.33, high + 0.05), (0.30, high + 0.07)], 2)
    neck = [(0.30, high + 0.07), (0.30, high + 0.17)]
    echinus = [(0.33, high + 0.17), (0.35, high + 0.19), (0.42, high + 0.235), (0.45, high + 0.275), (0.44, high + 0.30)]
    mesh.add(lathe([bead, neck, spline(echinus, 2)], 32))
    return mesh.add(flat(box((-0.48, high + 0.295, -0.48), (0.48, CAPITAL, 0.48))))


def archivolt(centre, segments=24):
    """Moulding round an arch in the plane z = 0, 0.2 wide, 0.06 proud."""
    profile = [(0.0, 0.0), (0.0, 0.035), (0.075, 0.035), (0.09, 0.06), (0.16, 0.06), (0.20, 0.03), (0.20, 0.0)]
    mesh = Mesh()
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        def point(t, a):
            r = ARCH + 0.004 + r0 + (r1 - r0) * t
            return (centre - r * math.cos(a), SPRING + r * math.sin(a), z0 + (z1 - z0) * t)
        mesh.add(patch(lambda a, t: point(t, a), even(0.0, math.pi, segments), [0.0, 1.0]))
    return mesh


def along_hall(bay):
    """The bay's mesh for every bay; bay n begins at panel x = n * BAY - FIRST, that is at z = FIRST - n * BAY."""
    mesh = Mesh()
    for n in range(BAYS):
        mesh.add(bay(n * BAY - FIRST))
    return mesh


def arcade():
    """Eight arches, the wall above them and their mouldings, facing +x at x = 0 and -x at x = -DEPTH."""
    def bay(x):
        mesh = arched_panel((x, SPRING), (x + BAY, TOP), SPRING, SPRING, ARCH, 32).add(archivolt(x + BAY / 2))
        back = Mesh().add(mesh, lambda p: (2 * x + BAY - p[0], p[1], -DEPTH - p[2]), lambda n: (-n[0], n[1], -n[2]))
        return mesh.add(back).add(arched_reveal(DEPTH, x + BAY / 2, ARCH, SPRING, SPRING, 32))
    return Mesh().add(along_hall(bay), turned, turned)


def window_wall():
    """Outer wall with an arched window in every bay, facing +x at x = 0; the windows are 0.5 deep."""
    def bay(x):
        mesh = arched_panel((x, 0.0), (x + BAY, TOP), 1.1, 3.9, 0.95, 24)
        return mesh.add(arched_reveal(0.5, x + BAY / 2, 0.95, 1.1, 3.9, 24))
    return Mesh().add(along_hall(bay), turned, turned)


def pilasters():
    """Half columns of the outer wall, square, between the bays, on the plane x = 0."""
    mesh = Mesh()
    for n in range(1, BAYS):
        z = FIRST - n * BAY
        mesh.add(flat(box((-0.01, -0.01, z - 0.30), (0.14, TOP - 0.28, z + 0.30), "XzZ")))
        mesh.add(flat(box((-0.01, -0.01, z - 0.36), (0.20, 0.32, z + 0.36), "XYzZ")))
        mesh.add(flat(box((-0.01, TOP - 0.28, z - 0.36), (0.20, TOP + 0.01, z + 0.36), "XyzZ")))
    return mesh


def vault():
    """Barrel vault over the nave, with transverse ribs over the columns."""
    def barrel(r):
        return lambda a, z: (-r * math.cos(a), TOP + 0.2 + r * math.sin(a), z)

    mesh = patch(barrel(NAVE), even(0.0, math.pi, 48), even(LAST, FIRST, BAYS))
    for n in range(1, BAYS):
        z = FIRST - n * BAY
        r = NAVE - 0.12
        mesh.add(patch(barrel(r), even(0.0, math.pi, 48), [z - 0.3, z + 0.3]))
        for side, order in ((z - 0.3, -1), (z + 0.3, 1)):
            outer, inner = arch_points(0.0, NAVE + 0.01, TOP + 0.2, 48), arch_points(0.0, r, TOP + 0.2, 48)
            for i in range(48):
                face = [inner[i], inner[i + 1], outer[i + 1], outer[i]]
                mesh.add_flat_polygon(*((x, y, side) for x, y in face[::order]))
    return mesh


def cornice():
    """Moulding on top of an arcade, along the hall, facing +x: its wall is x = 0, the vault begins on it at y = TOP + 0.2."""
    profile = [(-0.01, TOP - 0.16), (0.04, TOP - 0.14), (0.06, TOP - 0.04), (0.14, TOP), (0.20, TOP + 0.08), (0.22, TOP + 0.13),
               (0.22, TOP + 0.2), (-0.02, TOP + 0.2)]
    mesh = Mesh()
    for (x0, y0), (x1, y1) in zip(profile, profile[1:]):
        mesh.add_flat_polygon((x0, y0, FIRST), (x0, y0, LAST), (x1, y1, LAST), (x1, y1, FIRST))
    return mesh


def floor_slabs(odd):
    """Every second slab, 0.8 square, of a floor from -AISLE to AISLE with bevelled edges 8 mm wide and 4 mm deep."""
    mesh, size, edge, low = Mesh(), 0.8, 0.008, -0.004
    columns, rows = math.ceil(2 * AISLE / size), round((FIRST - LAST) / size)
    for i in range(columns):
        for j in range(rows):
            if (i + j) % 2 != odd:
                continue
            x, z = -columns * size / 2 + i * size, FIRST - j * size
            outer = [(x, low, z), (x + size, low, z), (x + size, low, z - size), (x, low, z - size)]
            x0, x1, z0, z1 = x + edge, x + size - edge, z - edge, z - size + edge
            inner = [(x0, 0.0, z0), (x1, 0.0, z0), (x1, 0.0, z1), (x0, 0.0, z1)]
            mesh.add_flat_polygon(*inner)
            for k in range(4):
                mesh.add_flat_polygon(outer[k], outer[(k + 1) % 4], inner[(k + 1) % 4], inner[k])
    return mesh


def steps():
    """Four steps of the nave up to a dais 0.64 high, from z = -16.6 to the end wall."""
    mesh = Mesh()
    for i in range(4):
        z, y = -16.6 - 0.36 * i, 0.16 * i
        deep = 0.36 if i < 3 else z - LAST
        mesh.add_flat_polygon((-2.3, y, z), (2.3, y, z), (2.3, y + 0.16, z), (-2.3, y + 0.16, z))
        mesh.add_flat_polygon((-2.3, y + 0.16, z), (2.3, y + 0.16, z), (2.3, y + 0.16, z - deep), (-2.3, y + 0.16, z - deep))
        for x, order in ((2.3, 1), (-2.3, -1)):
            side = [(x, -0.01, z), (x, -0.01, z - deep), (x, y + 0.16, z - deep), (x, y + 0.16, z)]
            mesh.add_flat_polygon(*side[::order])
    return mesh


def end_wall():
    """End of the hall in the plane z = 0, facing +z, with a round niche of radius 1.3 under a half dome.
    It reaches behind vault and aisles."""
    sill, spring, r = 0.64, 3.6, 1.3
    mesh = arched_panel((-AISLE - 0.01, -0.01), (AISLE + 0.01, TOP + 0.2 + NAVE + 0.01), sill, spring, r, 32)

    def inward(a, b):
        return (math.cos(a) * math.cos(b), -math.sin(b), math.sin(a) * math.cos(b))

    mesh.add(patch(lambda a, y: (-r * math.cos(a), y, -r * math.sin(a)), even(0.0, math.pi, 32), even(sill, spring, 2)))
    mesh.add(patch(lambda a, b: (-r * math.cos(a) * math.cos(b), spring + r * math.sin(b), -r * math.sin(a) * math.cos(b)),
                   even(0.0, math.pi, 32), even(0.0, math.pi / 2, 16), inward))
    mesh.add_flat_polygon(*((-r * math.cos(a), sill, -r * math.sin(a)) for a in even(0.0, math.pi, 32)[::-1]))
    return mesh


def urn():
    """A covered urn on a round pedestal, 2.0 high."""
    drum = [(0.42, 0.12), (0.36, 0.2), (0.35, 0.3), (0.35, 0.7), (0.38, 0.8), (0.44, 0.84)]
    pedestal = [[(0.48, -0.01), (0.48, 0.12)], [(0.48, 0.12), (0.42, 0.12)], spline(drum, 2),
                [(0.44, 0.84), (0.44, 0.92)], [(0.44, 0.92), (0.20, 0.92)]]
    belly = [(0.20, 0.92), (0.12, 0.98), (0.09, 1.05), (0.20, 1.14), (0.33, 1.32), (0.36, 1.48), (0.28, 1.62), (0.25, 1.68), (0.30, 1.74)]
    lid = [(0.30, 1.74), (0.22, 1.81), (0.07, 1.86), (0.05, 1.90), (0.08, 1.95), (0.06, 1.99), (0.0, 2.0)]
    body = [spline(belly, 3), spline(lid, 2)]
    return lathe(pedestal + body, 36)


MESHES = {
    "hall-column.ply": column, "hall-arcade.ply": arcade, "hall-windows.ply": window_wall, "hall-pilasters.ply": pilasters,
    "hall-vault.ply": vault, "hall-cornice.ply": cornice, "hall-slabs-even.ply": lambda: floor_slabs(0),
    "hall-slabs-odd.ply": lambda: floor_slabs(1), "hall-steps.ply": steps, "hall-end.ply": end_wall, "hall-urn.ply": urn,
}
