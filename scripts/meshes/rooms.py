"""Meshes of door-ajar.xml and thin-walls.xml [m]: flat furniture as OBJ, pottery as PLY with normals. Furniture stands on y = 0, its feet
2 mm in the floor, so that no face lies in another one."""
import math

from meshes.mesh import Mesh
from meshes.shapes import box, even, lathe, spline, tube

SUNK = 0.002


def boxes(*corners):
    mesh = Mesh()
    for low, high in corners:
        mesh.add(box(low, high))
    return mesh


def table():
    """1.5 x 0.8, 0.74 high; its middle is the origin."""
    mesh = boxes(((-0.75, 0.705, -0.40), (0.75, 0.74, 0.40)),
                 ((-0.66, 0.62, -0.31), (0.66, 0.71, -0.29)), ((-0.66, 0.62, 0.29), (0.66, 0.71, 0.31)),
                 ((-0.66, 0.62, -0.30), (-0.64, 0.71, 0.30)), ((0.64, 0.62, -0.30), (0.66, 0.71, 0.30)))
    for x in (-0.65, 0.65):
        for z in (-0.30, 0.30):
            mesh.add(box((x - 0.035, -SUNK, z - 0.035), (x + 0.035, 0.71, z + 0.035)))
    return mesh


def chair():
    """0.44 x 0.44, seat at 0.45, its back at -z."""
    mesh = boxes(((-0.22, 0.42, -0.22), (0.22, 0.45, 0.22)))
    for x in (-0.19, 0.19):
        mesh.add(box((x - 0.02, -SUNK, 0.17), (x + 0.02, 0.425, 0.21)))
        mesh.add(box((x - 0.02, -SUNK, -0.21), (x + 0.02, 0.92, -0.17)))
    for y in (0.60, 0.72, 0.84):
        mesh.add(box((-0.18, y, -0.20), (0.18, y + 0.05, -0.18)))
    return mesh


def shelf():
    """1.2 wide, 0.28 deep, 1.1 high, open at the front (+z), with two boards."""
    return boxes(((-0.60, -SUNK, 0.0), (-0.57, 1.1, 0.28)), ((0.57, -SUNK, 0.0), (0.60, 1.1, 0.28)),
                 ((-0.61, 1.095, 0.0), (0.61, 1.12, 0.29)), ((-0.575, -SUNK, 0.001), (0.575, 1.1, 0.02)),
                 ((-0.575, 0.08, 0.01), (0.575, 0.10, 0.275)), ((-0.575, 0.42, 0.01), (0.575, 0.44, 0.275)),
                 ((-0.575, 0.76, 0.01), (0.575, 0.78, 0.275)))


def books():
    """A row of 14 books, 0.52 long, on y = 0, spines to +z; sizes come from a fixed pattern."""
    mesh, x = Mesh(), 0.0
    for i in range(14):
        thick, high, deep = 0.026 + 0.003 * (i * 5 % 7), 0.20 + 0.012 * (i * 7 % 9), 0.15 + 0.006 * (i * 3 % 5)
        mesh.add(box((x, -SUNK, 0.0), (x + thick, high, deep)))
        x += thick + 0.002
    return mesh


def frame():
    """Picture frame of 0.7 x 0.5, its back at z = 0."""
    return boxes(((-0.35, -0.25, 0.0), (0.35, -0.21, 0.03)), ((-0.35, 0.21, 0.0), (0.35, 0.25, 0.03)),
                 ((-0.35, -0.211, 0.001), (-0.31, 0.211, 0.029)), ((0.31, -0.211, 0.001), (0.35, 0.211, 0.029)))


def door_leaf():
    """A leaf of 0.94 x 2.10 with two raised panels and handles. Its hinge is the y axis; shut, it lies at x < 0, 1 mm before z = 0."""
    mesh = boxes(((-0.94, -SUNK, 0.001), (0.0, 2.10, 0.041)))
    for low, high in ((0.20, 0.95), (1.10, 1.95)):
        mesh.add(box((-0.79, low, 0.04), (-0.15, high, 0.048)))
        mesh.add(box((-0.79, low, -0.007), (-0.15, high, 0.002)))
    for low, high in ((0.04, 0.085), (-0.043, 0.002)):
        mesh.add(box((-0.89, 1.02, low), (-0.87, 1.04, high)))
    mesh.add(box((-0.895, 1.018, 0.075), (-0.77, 1.042, 0.09)))
    mesh.add(box((-0.895, 1.018, -0.048), (-0.77, 1.042, -0.033)))
    return mesh


def doorway(width, height, opening, top, depth):
    """A wall from z = 0 back to z = -depth with a rectangular doorway (left, right). It reaches 1 cm into floor, ceiling and side walls."""
    x = [-width / 2 - 0.01, opening[0], opening[1], width / 2 + 0.01]
    y = [-0.01, top, height + 0.01]
    mesh = Mesh()
    for z, order in ((0.0, 1), (-depth, -1)):
        for i, j in ((0, 0), (2, 0), (0, 1), (1, 1), (2, 1)):
            corners = [(x[i], y[j], z), (x[i + 1], y[j], z), (x[i + 1], y[j + 1], z), (x[i], y[j + 1], z)]
            mesh.add_polygon(*corners[::order])
    mesh.add_polygon((x[1], y[0], 0.0), (x[1], y[0], -depth), (x[1], y[1], -depth), (x[1], y[1], 0.0))
    mesh.add_polygon((x[2], y[0], -depth), (x[2], y[0], 0.0), (x[2], y[1], 0.0), (x[2], y[1], -depth))
    mesh.add_polygon((x[1], y[1], 0.0), (x[1], y[1], -depth), (x[2], y[1], -depth), (x[2], y[1], 0.0))
    return mesh


def other_room():
    """Floor, ceiling and three walls of the room beyond the doorway, fronts inward, open where the wall with the doorway stands."""
    mesh = box((-2.5, 0.0, -3.6), (2.5, 2.8, 0.0), "xXyYz")
    mesh.faces = [face[::-1] for face in mesh.faces]
    return mesh


def floor_boards(odd):
    """Boards of a floor of 5 x 5, 12.5 cm wide, along z from 0 to 5; every second one."""
    mesh = Mesh()
    for i in range(odd, 40, 2):
        x = -2.5 + 0.125 * i
        mesh.add_polygon((x, 0.0, 0.0), (x, 0.0, 5.0), (x + 0.125, 0.0, 5.0), (x + 0.125, 0.0, 0.0))
    return mesh


def vase():
    """0.34 high, open at the top."""
    outside = spline([(0.055, 0.004), (0.085, 0.05), (0.115, 0.13), (0.10, 0.20), (0.048, 0.265), (0.040, 0.295), (0.062, 0.335)], 4)
    inside = spline([(0.054, 0.335), (0.033, 0.295), (0.042, 0.262), (0.09, 0.20), (0.10, 0.13), (0.0, 0.03)], 3)
    return lathe([[(0.0, 0.0), (0.05, 0.0)], outside, [(0.062, 0.335), (0.054, 0.335)], inside], 36)


def bowl():
    """0.34 across, 0.11 high."""
    outside = spline([(0.062, 0.006), (0.066, 0.018), (0.12, 0.045), (0.155, 0.08), (0.17, 0.11)], 4)
    inside = spline([(0.162, 0.11), (0.147, 0.082), (0.11, 0.05), (0.05, 0.03), (0.0, 0.027)], 4)
    return lathe([[(0.0, 0.0), (0.06, 0.0)], outside, [(0.17, 0.11), (0.162, 0.11)], inside], 48)


def jug():
    """A coffee pot, 0.30 high, with lid, handle (-x) and spout (+x)."""
    body = spline([(0.085, 0.004), (0.098, 0.03), (0.105, 0.09), (0.088, 0.16), (0.064, 0.215), (0.062, 0.235)], 4)
    lid = spline([(0.066, 0.242), (0.052, 0.258), (0.018, 0.272), (0.012, 0.279), (0.022, 0.289), (0.017, 0.301), (0.0, 0.305)], 3)
    mesh = lathe([[(0.0, 0.0), (0.082, 0.0)], body, [(0.062, 0.235), (0.069, 0.237), (0.066, 0.242)], lid], 36)
    handle = spline([(-0.060, 0.205), (-0.115, 0.225), (-0.165, 0.195), (-0.165, 0.13), (-0.130, 0.08), (-0.090, 0.065)], 4)
    spout = spline([(0.085, 0.075), (0.135, 0.10), (0.152, 0.16), (0.185, 0.222)], 6)
    mesh.add(tube(handle, [0.010] * len(handle), 10))
    inner = [0.026 - 0.014 * t for t in even(0.0, 1.0, len(spout) - 1)]
    mesh.add(tube(spout, inner, 16))
    return mesh


def bottle():
    """0.42 high, closed."""
    body = spline([(0.05, 0.004), (0.055, 0.02), (0.055, 0.20), (0.048, 0.25), (0.022, 0.30), (0.016, 0.34), (0.016, 0.395)], 4)
    lip = spline([(0.019, 0.395), (0.021, 0.405), (0.019, 0.42)], 2)
    return lathe([[(0.0, 0.0), (0.048, 0.0)], body, [(0.016, 0.395), (0.019, 0.395)], lip, [(0.019, 0.42), (0.0, 0.42)]], 32)


MESHES = {
    "table.obj": table, "chair.obj": chair, "shelf.obj": shelf, "books.obj": books, "frame.obj": frame, "door-leaf.obj": door_leaf,
    "other-room.obj": other_room, "doorway.obj": lambda: doorway(5.0, 2.8, (0.45, 1.35), 2.08, 0.12),
    "thin-doorway.obj": lambda: doorway(4.0, 3.2, (-0.6, 0.9), 2.3, 0.02),
    "boards-even.obj": lambda: floor_boards(0), "boards-odd.obj": lambda: floor_boards(1),
    "vase.ply": vase, "bowl.ply": bowl, "jug.ply": jug, "bottle.ply": bottle,
}
