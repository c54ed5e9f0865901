"""Paint a soft elbow with three values, then drag the hand: it turns by itself, the elbow folds."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from app.bundled import ASSETS
from solver import Deformer, interpolate_softness, load_mesh


def main(output: Path) -> None:
    mesh = load_mesh(ASSETS / "arm.obj")
    V, F = mesh.vertices, mesh.faces
    x = V[:, 0] / V[:, 0].max()  # 0 at the shoulder, 1 at the fingers
    shoulder, hand = np.flatnonzero(x < 0.1), np.flatnonzero(x > 0.75)

    # Rigid above and below, soft at the elbow; harmonic in between.
    elbow = np.flatnonzero(abs(x - 0.42) < 0.03)
    rigid = np.flatnonzero(abs(x - 0.42) > 0.2)
    painted = np.concatenate([rigid, elbow])
    values = np.concatenate([np.zeros(len(rigid)), np.ones(len(elbow))])
    softness = interpolate_softness(V, F, painted, values)

    deformer = Deformer(V, F, fixed=shoulder, handles=[hand], softness=softness)
    palm = V[hand].mean(axis=0)
    target = palm + [-0.5 * palm[0], 0.5 * palm[0], 0.0]
    T = deformer.orient(0, palm, target, [np.eye(4)])
    mesh.save(output / "soft.obj", deformer.pose([T], rigid=4))
    # The same drag with a uniform arm: only the material changes, the analysis is kept.
    uniform = deformer.rebind(softness=None)
    mesh.save(output / "uniform.obj", uniform.pose([T], rigid=4))
    turn = np.degrees(np.arccos((np.trace(T[:3, :3]) - 1) / 2))
    print(f"the hand turned by {turn:.0f} degrees")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
