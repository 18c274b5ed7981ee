#!/usr/bin/env python3
"""Writes the computed meshes of scenes/ into scenes/meshes, or into another folder:

    scripts/make_meshes.py [FOLDER]

Equal on every run and platform; needs the standard library alone.
"""
import sys
from pathlib import Path

from meshes import hall, rooms


def main():
    root = Path(__file__).resolve().parent.parent
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else root / "scenes" / "meshes"
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in {**rooms.MESHES, **hall.MESHES}.items():
        mesh = make()
        comment = "Made by scripts/make_meshes.py."
        if name.endswith(".obj"):
            mesh.write_obj(folder / name, comment)
        else:
            mesh.write_ply(folder / name, comment)
        print(f"{name:20} {mesh.triangle_count():6} triangles")


if __name__ == "__main__":
    main()
