#!/usr/bin/env python3
"""Writes scenes/interior.gltf and scenes/interior.glb, a furnished room, or into another folder:

    scripts/make_gltf_scene.py [FOLDER]

Equal on every run and platform; needs the standard library alone. Lengths in metres, +y up.
"""
import base64
import json
import math
import struct
import sys
import zlib
from pathlib import Path

BYTE, FLOAT, SHORT = 5121, 5126, 5123


class Gltf:
    """The document and its one buffer."""

    def __init__(self):
        self.bytes = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": "pencil scripts/make_gltf_scene.py"}, "scene": 0, "scenes": [{"nodes": []}],
                     "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_transmission",
                                        "KHR_texture_transform"]}

    def add(self, kind, element):
        """Index of the element in the list of its kind."""
        elements = self.json.setdefault(kind, [])
        elements.append(element)
        return len(elements) - 1

    def view(self, content):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        offset = len(self.bytes)
        self.bytes += content
        return self.add("bufferViews", {"buffer": 0, "byteOffset": offset, "byteLength": len(content)})

    def accessor(self, rows, kind):
        numbers = [x for row in rows for x in row]
        extra = {}
        if kind == "VEC3":
            extra = {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]}
        view = self.view(struct.pack(f"<{len(numbers)}f", *numbers))
        return self.add("accessors", {"bufferView": view, "componentType": FLOAT, "count": len(rows), "type": kind, **extra})

    def indices(self, triangles):
        numbers = [i for t in triangles for i in t]
        view = self.view(struct.pack(f"<{len(numbers)}H", *numbers))
        return self.add("accessors", {"bufferView": view, "componentType": SHORT, "count": len(numbers), "type": "SCALAR"})

    def picture(self, width, height, pixel):
        """A texture whose pixel(x, y) gives three bytes."""
        rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))

        def chunk(kind, content):
            return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

        png = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
               chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
        image = self.add("images", {"bufferView": self.view(png), "mimeType": "image/png"})
        return self.add("textures", {"source": image})

    def mesh(self, name, material, positions, normals, uvs, triangles):
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor(normals, "VEC3"),
                      "TEXCOORD_0": self.accessor(uvs, "VEC2")}
        primitive = {"attributes": attributes, "indices": self.indices(triangles), "material": material}
        return self.add("meshes", {"name": name, "primitives": [primitive]})

    def node(self, **content):
        """At the root."""
        node = self.add("nodes", content)
        self.json["scenes"][0]["nodes"].append(node)
        return node

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(self.bytes)).decode()
        return json.dumps({**self.json, "buffers": [{"byteLength": len(self.bytes), "uri": uri}]}, separators=(",", ":"))

    def binary(self):
        text = json.dumps({**self.json, "buffers": [{"byteLength": len(self.bytes)}]}, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        content = bytes(self.bytes) + b"\0" * (-len(self.bytes) % 4)
        chunks = struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(content)) + b"BIN\0" + content
        return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def box():
    """[-1/2, 1/2]^3, fronts outward; every side has the whole picture."""
    positions, normals, uvs, triangles = [], [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            first = len(positions)
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = [0.0, 0.0, 0.0]
                corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = sign / 2, (u - 0.5) * sign, v - 0.5
                positions.append(tuple(corner))
                normals.append(tuple(float(sign) if k == axis else 0.0 for k in range(3)))
                uvs.append((float(u), float(v)))
            triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return positions, normals, uvs, triangles


def turned(profile, parts):
    """The surface that a profile of (radius, height) sweeps about the y axis, smooth."""
    positions, normals, uvs, triangles = [], [], [], []
    for i in range(parts + 1):
        c, s = math.cos(2 * math.pi * i / parts), math.sin(2 * math.pi * i / parts)
        for k, (r, y) in enumerate(profile):
            before, after = profile[max(k - 1, 0)], profile[min(k + 1, len(profile) - 1)]
            across, up = after[1] - before[1], before[0] - after[0]
            length = math.hypot(across, up)
            positions.append((r * c, y, r * s))
            normals.append((c * across / length, up / length, s * across / length))
            uvs.append((i / parts, k / (len(profile) - 1)))
    n = len(profile)
    for i in range(parts):
        for k in range(n - 1):
            a, b = i * n + k, (i + 1) * n + k
            if profile[k + 1][0] > 0:
                triangles.append((a, a + 1, b + 1))
            if profile[k][0] > 0:
                triangles.append((a, b + 1, b))
    return positions, normals, uvs, triangles


def wood(x, y):
    """Boards of four shades with a grain."""
    board = (y // 16) % 4
    grain = 10 * math.sin(0.35 * x + 3 * board + 2 * math.sin(0.5 * y)) - (40 if y % 16 == 0 else 0)
    return tuple(max(0, min(255, int(c + 12 * board + grain))) for c in (140, 96, 58))


def weave(x, y):
    """A carpet's pattern."""
    inside = 6 <= x < 58 and 6 <= y < 58
    return (150, 40, 35) if inside and (x // 4 + y // 4) % 2 else (190, 160, 110) if inside else (60, 20, 25)


def plain(name, colour, roughness, metallic=0.0, **extra):
    pbr = {"baseColorFactor": [*colour, 1.0], "metallicFactor": metallic, "roughnessFactor": roughness}
    return {"name": name, "pbrMetallicRoughness": pbr, **extra}


def pictured(name, texture, roughness, scale=(1, 1)):
    info = {"index": texture, "extensions": {"KHR_texture_transform": {"scale": list(scale)}}}
    return {"name": name, "pbrMetallicRoughness": {"baseColorTexture": info, "metallicFactor": 0.0, "roughnessFactor": roughness}}


class Room:
    def __init__(self):
        self.gltf = Gltf()
        self.box, self.meshes = box(), {}

    def material(self, content):
        return self.gltf.add("materials", content)

    def put(self, name, material, centre, size, angle=0.0):
        """A box."""
        if material not in self.meshes:
            self.meshes[material] = self.gltf.mesh(f"box of material {material}", material, *self.box)
        node = {"name": name, "mesh": self.meshes[material], "translation": list(centre), "scale": list(size)}
        if angle:
            node["rotation"] = [0.0, math.sin(angle / 2), 0.0, math.cos(angle / 2)]
        self.gltf.node(**node)

    def table(self, wood_of_it, x, z, height, width, depth):
        self.put("table top", wood_of_it, (x, height - 0.02, z), (width, 0.04, depth))
        for sx in (-1, 1):
            for sz in (-1, 1):
                self.put("leg", wood_of_it, (x + sx * (width / 2 - 0.05), (height - 0.04) / 2, z + sz * (depth / 2 - 0.05)),
                         (0.06, height - 0.04, 0.06))

    def light(self, light, **node):
        lights = self.gltf.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {}).setdefault("lights", [])
        lights.append(light)
        self.gltf.node(name=light["name"], extensions={"KHR_lights_punctual": {"light": len(lights) - 1}}, **node)


def make():
    room = Room()
    gltf = room.gltf
    wall = room.material(plain("wall", (0.78, 0.75, 0.7), 0.9))
    red = room.material(plain("red wall", (0.55, 0.14, 0.1), 0.9))
    floor = room.material(pictured("parquet", gltf.picture(64, 64, wood), 0.35, (3, 3)))
    carpet = room.material(pictured("carpet", gltf.picture(64, 64, weave), 1.0))
    oak = room.material(plain("oak", (0.42, 0.26, 0.13), 0.5))
    cloth = room.material(plain("cloth", (0.12, 0.2, 0.36), 0.95))
    brass = room.material(plain("brass", (0.89, 0.7, 0.36), 0.25, 1.0))
    glass = room.material(plain("glass", (0.97, 1.0, 0.98), 0.0, extensions={"KHR_materials_transmission": {"transmissionFactor": 1.0}}))
    lamp = room.material(plain("lamp", (0.8, 0.8, 0.8), 1.0, emissiveFactor=[1.0, 0.8, 0.55],
                               extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 12.0}}))

    # The room: 4 x 2.6 x 5, open towards the camera's side no more than a door.
    room.put("floor", floor, (0, -0.05, 0), (4.2, 0.1, 5.2))
    room.put("ceiling", wall, (0, 2.65, 0), (4.2, 0.1, 5.2))
    room.put("wall behind", wall, (0, 1.3, -2.55), (4.2, 2.6, 0.1))
    room.put("wall in front", wall, (0, 1.3, 2.55), (4.2, 2.6, 0.1))
    room.put("wall to the left", red, (-2.05, 1.3, 0), (0.1, 2.6, 5.2))
    room.put("wall to the right", wall, (2.05, 1.3, 0), (0.1, 2.6, 5.2))

    room.put("carpet", carpet, (0, 0.005, -0.4), (2.2, 0.01, 1.6))
    room.table(oak, 0.1, -0.4, 0.45, 1.1, 0.7)
    room.put("sofa seat", cloth, (-1.45, 0.24, -0.5), (0.85, 0.34, 1.9))
    room.put("sofa back", cloth, (-1.82, 0.58, -0.5), (0.22, 0.5, 1.9))
    for side in (-1, 1):
        room.put("sofa arm", cloth, (-1.45, 0.36, -0.5 + side * 0.95), (0.85, 0.5, 0.16))
    for level in range(4):
        room.put("shelf", oak, (1.1, 0.3 + 0.5 * level, -2.35), (1.5, 0.03, 0.3))
    for side in (-1, 1):
        room.put("shelf side", oak, (1.1 + side * 0.75, 1.0, -2.35), (0.03, 2.0, 0.3))
    colours = [room.material(plain(f"book {i}", c, 0.7)) for i, c in enumerate(((0.5, 0.1, 0.08), (0.1, 0.3, 0.15), (0.7, 0.6, 0.3)))]
    for i in range(21):
        height = 0.24 + 0.04 * math.sin(2.3 * i)
        level, place = divmod(i, 7)
        room.put("book", colours[(i * i) % 3], (0.5 + 0.13 * place, 0.315 + 0.5 * level + height / 2, -2.35), (0.05, height, 0.2))

    vase = gltf.mesh("vase", brass, *turned([(0, 0), (0.07, 0.0), (0.11, 0.07), (0.12, 0.13), (0.09, 0.2), (0.05, 0.26), (0.07, 0.31)], 32))
    gltf.node(name="vase", mesh=vase, translation=[0.35, 0.45, -0.5])
    ball = gltf.mesh("ball", glass, *turned([(0.12 * math.sin(math.pi * k / 16) if 0 < k < 16 else 0.0, 0.12 - 0.12 * math.cos(math.pi * k / 16))
                                             for k in range(17)], 32))
    gltf.node(name="glass ball", mesh=ball, translation=[-0.2, 0.45, -0.3])
    room.put("lamp foot", brass, (-1.7, 0.75, -1.9), (0.04, 1.5, 0.04))
    room.put("lamp plate", brass, (-1.7, 0.02, -1.9), (0.3, 0.03, 0.3), 0.4)
    room.put("lamp shade", lamp, (-1.7, 1.6, -1.9), (0.26, 0.26, 0.26), 0.4)

    room.light({"name": "bulb", "type": "point", "color": [1.0, 0.9, 0.75], "intensity": 1800.0}, translation=[0.5, 2.3, 0.9])
    tilt = -math.pi / 2  # along -y
    room.light({"name": "spot", "type": "spot", "color": [1.0, 0.95, 0.85], "intensity": 5000.0,
                "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}},
               translation=[0.1, 2.55, -0.4], rotation=[math.sin(tilt / 2), 0.0, 0.0, math.cos(tilt / 2)])

    pitch = -0.16
    gltf.add("cameras", {"type": "perspective", "perspective": {"yfov": 0.85, "aspectRatio": 4 / 3, "znear": 0.05}})
    gltf.node(name="camera", camera=0, translation=[0.35, 1.5, 2.3], rotation=[math.sin(pitch / 2), 0.0, 0.0, math.cos(pitch / 2)])
    return gltf


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent / "scenes"
    folder.mkdir(parents=True, exist_ok=True)
    gltf = make()
    (folder / "interior.gltf").write_text(gltf.text() + "\n")
    (folder / "interior.glb").write_bytes(gltf.binary())
    triangles = sum(gltf.json["accessors"][gltf.json["meshes"][node["mesh"]]["primitives"][0]["indices"]]["count"] // 3
                    for node in gltf.json["nodes"] if "mesh" in node)
    print(f"interior: {triangles} triangles")


if __name__ == "__main__":
    main()
