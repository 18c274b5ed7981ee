"""Triangle and polygon meshes, and the two file formats in which they are written.

Faces are counter-clockwise seen from the front. Coordinates are rounded before they are written, so that the same script gives the same
bytes whatever the last bit of the platform's sine is.
"""
import math
import struct

DIGITS = 5  # of a coordinate [m]: 10 micrometres


class Mesh:
    def __init__(self):
        self.positions = []  # (x, y, z)
        self.normals = []  # one per position, or empty: flat
        self.faces = []  # tuples of 3 or more indices

    def add_vertex(self, position, normal=None):
        """Index of a new vertex; all vertices of a mesh have a normal, or none has."""
        self.positions.append(tuple(position))
        if normal is not None:
            self.normals.append(tuple(normal))
        return len(self.positions) - 1

    def add_face(self, *corners):
        """Corners that lie in one place become one; a face of fewer than three is left out."""
        kept = [c for i, c in enumerate(corners) if rounded(self.positions[c]) != rounded(self.positions[corners[i - 1]])]
        if len(kept) >= 3:
            self.faces.append(tuple(kept))

    def add_polygon(self, *points):
        """A flat face with vertices of its own. In a mesh with normals they are the polygon's."""
        self.add_face(*(self.add_vertex(p) for p in points))

    def add_flat_polygon(self, *points):
        normal = unit(cross(sub(points[1], points[0]), sub(points[2], points[0])))
        self.add_face(*(self.add_vertex(p, normal) for p in points))

    def add(self, other, place=lambda p: p, turn=lambda n: n):
        """A copy of `other`, its positions through `place` and its normals through `turn`."""
        first = len(self.positions)
        self.positions += [place(p) for p in other.positions]
        self.normals += [turn(n) for n in other.normals]
        self.faces += [tuple(first + c for c in face) for face in other.faces]
        return self

    def triangle_count(self):
        return sum(len(face) - 2 for face in self.faces)

    def write_obj(self, path, comment):
        """Positions and polygons; vertices in one place become one, so that solids are closed."""
        index, lines = {}, ["# " + comment]
        faces = [[index.setdefault(rounded(self.positions[c]), len(index) + 1) for c in face] for face in self.faces]
        lines += ["v " + " ".join(f"{x:g}" for x in p) for p in index]
        lines += ["f " + " ".join(map(str, face)) for face in faces]
        with open(path, "w", encoding="ascii", newline="\n") as file:
            file.write("\n".join(lines) + "\n")

    def write_ply(self, path, comment):
        """Little-endian binary, triangles, with normals if the mesh has them."""
        fields = ["x", "y", "z"] + (["nx", "ny", "nz"] if self.normals else [])
        triangles = [(f[0], f[i], f[i + 1]) for f in self.faces for i in range(1, len(f) - 1)]
        header = ["ply", "format binary_little_endian 1.0", "comment " + comment, f"element vertex {len(self.positions)}"]
        header += [f"property float {name}" for name in fields]
        header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header\n"]
        with open(path, "wb") as file:
            file.write("\n".join(header).encode("ascii"))
            for i, p in enumerate(self.positions):
                file.write(struct.pack(f"<{len(fields)}f", *rounded(p), *(rounded(self.normals[i]) if self.normals else ())))
            for triangle in triangles:
                file.write(struct.pack("<B3i", 3, *triangle))


def rounded(p):
    return tuple(round(x, DIGITS) + 0.0 for x in p)  # + 0.0: no negative zero


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)
