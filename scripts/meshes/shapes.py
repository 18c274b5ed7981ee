"""Building blocks of the meshes: boxes, surfaces of revolution, tubes along curves, curved patches, walls with arched openings. y is up."""
import math

from meshes.mesh import Mesh, cross, sub, unit


def box(low, high, faces="xXyYzZ"):
    """An axis-aligned box, fronts outward; `faces` names those that are made: x is the side of low x, X that of high x."""
    mesh = Mesh()
    corner = [(high[0] if i & 1 else low[0], high[1] if i & 2 else low[1], high[2] if i & 4 else low[2]) for i in range(8)]
    sides = {"x": (0, 4, 6, 2), "X": (1, 3, 7, 5), "y": (0, 1, 5, 4), "Y": (2, 6, 7, 3), "z": (0, 2, 3, 1), "Z": (4, 5, 7, 6)}
    for name in faces:
        mesh.add_polygon(*(corner[i] for i in sides[name]))
    return mesh


def flat(mesh):
    """The mesh with normals of its faces, to be joined to meshes that have normals."""
    result = Mesh()
    for face in mesh.faces:
        result.add_flat_polygon(*(mesh.positions[c] for c in face))
    return result


def patch(point, us, vs, normal=None):
    """Smooth surface point(u, v) over the grid us x vs, both increasing; the front is the side of d/du x d/dv, computed by differences
    where `normal` does not give it."""
    mesh, step = Mesh(), 1e-5

    def difference_normal(u, v):
        du = sub(point(u + step, v), point(u - step, v))
        dv = sub(point(u, v + step), point(u, v - step))
        return unit(cross(du, dv))

    for v in vs:
        for u in us:
            mesh.add_vertex(point(u, v), (normal or difference_normal)(u, v))
    n = len(us)
    for j in range(len(vs) - 1):
        for i in range(n - 1):
            mesh.add_face(j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i)
    return mesh


def even(first, last, count):
    """count + 1 numbers from first to last."""
    return [first + (last - first) * i / count for i in range(count + 1)]


def spline(points, steps):
    """Points of the Catmull-Rom curve through `points` (of any dimension), `steps` to each section."""
    ends = [points[0]] + list(points) + [points[-1]]
    curve = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        for t in even(0.0, 1.0, steps)[:-1]:
            curve.append(tuple(0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t**3)
                               for p, q, r, s in zip(a, b, c, d)))
    return curve + [tuple(points[-1])]


def lathe(profiles, sides):
    """Surface of revolution about the y axis. Each profile is a list of (radius, y), smooth within, the outside on its right-hand side
    (upwards for an outer wall); the edge between two profiles is sharp."""
    mesh = Mesh()
    for profile in profiles:
        first = len(mesh.positions)
        for i, (radius, y) in enumerate(profile):
            before, after = profile[max(i - 1, 0)], profile[min(i + 1, len(profile) - 1)]
            outward, up, _ = unit((after[1] - before[1], before[0] - after[0], 0.0))
            for k in range(sides):
                c, s = math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)
                mesh.add_vertex((radius * c, y, radius * s), (outward * c, up, outward * s))
        for i in range(len(profile) - 1):
            low, high = first + i * sides, first + (i + 1) * sides
            for k in range(sides):
                following = (k + 1) % sides
                mesh.add_face(low + k, high + k, high + following, low + following)
    return mesh


def tube(path, radii, sides):
    """Round tube along the points of `path`, which lies in the plane z = 0; ends are open."""
    mesh = Mesh()
    for i, (x, y) in enumerate(path):
        before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        tx, ty, _ = unit((after[0] - before[0], after[1] - before[1], 0.0))
        for k in range(sides):
            c, s = math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)
            normal = (-ty * c, tx * c, s)
            mesh.add_vertex((x + radii[i] * normal[0], y + radii[i] * normal[1], radii[i] * s), normal)
    for i in range(len(path) - 1):
        for k in range(sides):
            following = (k + 1) % sides
            mesh.add_face(i * sides + k, i * sides + following, (i + 1) * sides + following, (i + 1) * sides + k)
    return mesh


def arch_points(centre, radius, spring, segments):
    """Points (x, y) of a semicircle over the springing line, from the left to the right."""
    return [(centre - radius * math.cos(a), spring + radius * math.sin(a)) for a in even(0.0, math.pi, segments)]


def arched_panel(low, high, sill, spring, radius, segments):
    """Flat panel in the plane z = 0, front to +z, from low to high (x, y), with an opening under a round arch in its middle."""
    mesh, centre = Mesh(), (low[0] + high[0]) / 2
    left, right = centre - radius, centre + radius
    levels = [low[1], sill, spring, high[1]]

    def quad(x0, y0, x1, y1, top0, top1):
        mesh.add_flat_polygon((x0, y0, 0.0), (x1, y1, 0.0), (x1, top1, 0.0), (x0, top0, 0.0))

    for y0, y1 in zip(levels, levels[1:]):
        if y1 > y0:
            quad(low[0], y0, left, y0, y1, y1)
            quad(right, y0, high[0], y0, y1, y1)
    arch = arch_points(centre, radius, spring, segments)
    for (x0, y0), (x1, y1) in zip(arch, arch[1:]):
        quad(x0, y0, x1, y1, high[1], high[1])
        if sill > low[1]:
            quad(x0, low[1], x1, low[1], sill, sill)
    return mesh


def arched_reveal(depth, centre, radius, sill, spring, segments):
    """Inside of an arched opening, from z = 0 back to z = -depth: jambs and soffit, and the sill if it is below the springing line."""
    mesh = patch(lambda a, z: (centre - radius * math.cos(a), spring + radius * math.sin(a), z),
                 even(0.0, math.pi, segments), [-depth, 0.0])
    if sill < spring:
        left, right = centre - radius, centre + radius
        mesh.add_flat_polygon((left, sill, 0.0), (left, sill, -depth), (left, spring, -depth), (left, spring, 0.0))
        mesh.add_flat_polygon((right, sill, -depth), (right, sill, 0.0), (right, spring, 0.0), (right, spring, -depth))
        mesh.add_flat_polygon((left, sill, 0.0), (right, sill, 0.0), (right, sill, -depth), (left, sill, -depth))
    return mesh
