"""Grab a soft region on a surface that is bound already: nothing is factorised again."""

from __future__ import annotations

import sys
from pathlib import Path
from time import perf_counter

import numpy as np

from app.bundled import ASSETS
from solver import Deformer, load_mesh


def main(output: Path) -> None:
    mesh = load_mesh(ASSETS / "cactus.obj")
    V, F = mesh.vertices, mesh.faces
    height = V[:, 1] - V[:, 1].min()

    start = perf_counter()
    foot = np.flatnonzero(height < 0.1 * height.max())
    deformer = Deformer(V, F, fixed=foot)
    bound = perf_counter()

    # A brush's falloff around the highest point: 1 there, 0 beyond the radius.
    distance = np.linalg.norm(V - V[height.argmax()], axis=1)
    weights = np.clip(1 - distance / (0.15 * height.max()), 0, None)
    soft = deformer.grab(weights)
    grabbed = perf_counter()

    T = np.eye(4)
    T[:3, 3] = [0.3 * height.max(), -0.05 * height.max(), 0.0]
    X = soft.pose([T], rigid=1)
    mesh.save(output / "cactus.obj", X)
    moved = (weights @ (X - V)) / weights.sum()
    print(f"bound in {1000 * (bound - start):.0f} ms, grabbed in {1000 * (grabbed - bound):.0f} ms")
    print(f"the region moved by {np.round(moved, 3)} on average, asked for {T[:3, 3].round(3)}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
