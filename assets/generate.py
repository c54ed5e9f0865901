"""Writes every mesh of this folder and the sessions: `python -m assets.generate`."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assets.generator import figure
from assets.generator.cactus import cactus
from assets.generator.character.dressed import dressed, dressed_session
from assets.generator.elbow import session_text
from assets.generator.objtext import parts_text, quad_text, triangle_text
from assets.generator.primitives import bar, bumpy_plane, cylinder
from assets.generator.quads import dog
from assets.generator.surface import Enlargement, polygonise, remesh
from solver import load_mesh
from solver.types import FloatArray, IntArray

FOLDER = Path(__file__).resolve().parent
AXIS = (figure.ARM_HEIGHT, figure.ARM_DEPTH)
"""Where the arms run: y and z."""


def mannequin() -> tuple[FloatArray, IntArray]:
    """The figure, with smaller triangles on arms, still smaller ones on hands, and on the head."""
    field = figure.body()
    V, F = polygonise(field, (-1.02, -0.03, -0.20), (1.02, 1.86, 0.22), 0.005)
    hands = Enlargement(axis=0, centre=AXIS, start=0.56, end=0.80, scale=1.9)
    arms = Enlargement(axis=0, centre=AXIS, start=0.20, end=0.36, scale=1.4)
    head = Enlargement(axis=1, centre=(0.0, 0.0), start=1.50, end=1.62, scale=1.9)
    return remesh(field, V, F, 0.0192, (hands, arms, head))


def arm() -> tuple[FloatArray, IntArray]:
    """One arm of the figure, moved so that it runs along the x axis."""
    field = figure.arm()
    V, F = polygonise(field, (0.05, 1.32, -0.12), (1.02, 1.52, 0.14), 0.004)
    hand = Enlargement(axis=0, centre=AXIS, start=0.60, end=0.80, scale=1.4)
    V, F = remesh(field, V, F, 0.0095, (hand,))
    return V - [V[:, 0].min(), *AXIS], F


def plant() -> tuple[FloatArray, IntArray]:
    """The cactus, with even triangles."""
    field = cactus()
    V, F = polygonise(field, (-0.80, -0.05, -0.40), (0.85, 2.15, 0.40), 0.02)
    return remesh(field, V, F, 0.0316, ())


def write(name: str, text: str) -> None:
    (FOLDER / name).write_text(text, encoding="ascii", newline="\n")


def main() -> None:
    V, F = mannequin()
    V = np.round(V, 6)
    write("mannequin.obj", triangle_text("A human figure in T-pose, y up, facing +z", V, F))
    write("mannequin-elbow.json", session_text("mannequin.obj", V, F))
    parts = dressed(V, F)
    write("dressed.obj", parts_text("A dressed figure of many pieces, y up, facing +z", parts))
    write("dressed-elbow.json", dressed_session("dressed.obj", parts))
    mesh = load_mesh(FOLDER / "dressed.obj")
    mesh.save(FOLDER / "dressed.glb", mesh.vertices)
    write("arm.obj", triangle_text("An arm with its hand, along x", *arm()))
    write("bar.obj", triangle_text("A bar of square section, along x", *bar()))
    write("cylinder.obj", triangle_text("A closed cylinder, along x", *cylinder()))
    write("bumpy_plane.obj", triangle_text("An open square sheet with bumps, y up", *bumpy_plane()))
    write("cactus.obj", triangle_text("A cactus with two arms, y up", *plant()))
    write("dog.obj", quad_text("A toy dog of quads with UVs, normals and groups", dog()))


if __name__ == "__main__":
    main()
