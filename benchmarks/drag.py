"""What a drag costs on the mannequin: `python -m benchmarks.drag`."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.peers import Arap
from benchmarks.timing import medians, seconds, table
from solver import Deformer, Mesh, load_mesh
from solver.types import FloatArray, IntArray

ASSETS = Path(__file__).resolve().parents[1] / "assets"
GOAL = 20.0


@dataclass(frozen=True)
class Scene:
    """The mannequin's arm: fixed body, hand as handle, soft elbow."""

    mesh: Mesh
    fixed: IntArray
    hand: IntArray
    softness: FloatArray

    @classmethod
    def load(cls) -> Scene:
        session = json.loads((ASSETS / "mannequin-elbow.json").read_text(encoding="utf-8"))
        return cls(
            load_mesh(ASSETS / session["mesh"]["path"]),
            np.array(session["fixed"]),
            np.array(session["handles"][0]["vertices"]),
            np.array(session["softness"]),
        )

    def bind(self, softness: FloatArray) -> Deformer:
        mesh = self.mesh
        return Deformer(mesh.vertices, mesh.faces, self.fixed, [self.hand], softness)

    @property
    def target(self) -> tuple[FloatArray, FloatArray]:
        """The hand's centre, and where it is dragged to."""
        V = self.mesh.vertices
        centre = V[self.hand].mean(axis=0)
        return centre, centre + 0.15 * np.linalg.norm(np.ptp(V, axis=0)) * np.array([-1, 1, 1])


def measure(scene: Scene) -> dict[str, float]:
    """Seconds of every step."""
    deformer = scene.bind(scene.softness)
    grabbed, target = scene.target
    start = [np.eye(4)]
    T = deformer.orient(0, grabbed, target, start)
    factor, free = deformer.system.factor, len(deformer.system.free)
    columns = np.random.default_rng(0).normal(size=(free, 3))

    def drag() -> FloatArray:
        return deformer.pose([deformer.orient(0, grabbed, target, start)])

    return {
        "bind": seconds(lambda: scene.bind(scene.softness), 5),
        "rebind another softness": seconds(lambda: deformer.rebind(softness=scene.softness**2), 5),
        "back-substitution, 3 columns": seconds(lambda: factor.solve(columns), 50),
        "pose, rigid 0": seconds(lambda: deformer.pose([T]), 200),
        "orient": seconds(lambda: deformer.orient(0, grabbed, target, start), 200),
        "orient + pose, rigid 0": seconds(drag, 200),
        "pose, rigid 1": seconds(lambda: deformer.pose([T], rigid=1), 50),
    }


def measure_arap(scene: Scene) -> dict[str, float]:
    """Seconds of libigl's as-rigid-as-possible deformation under the same constraints."""
    V, F = scene.mesh.vertices, scene.mesh.faces
    held = np.concatenate([scene.fixed, scene.hand])
    grabbed, target = scene.target
    goal = V[held].copy()
    goal[len(scene.fixed) :] += target - grabbed
    return medians(Arap(V, F, held, goal).tasks(), 3)


def main() -> None:
    scene = Scene.load()
    times = measure(scene) | measure_arap(scene)
    n, m = len(scene.mesh.vertices), len(scene.mesh.faces)
    print(f"mannequin: {n} vertices, {m} faces, {n - len(scene.fixed)} vertices not fixed\n")
    rows = [[name, f"{1000 * t:.3f}"] for name, t in times.items()]
    print(table(["step", "median, ms"], rows))
    ratio = times["back-substitution, 3 columns"] / times["pose, rigid 0"]
    print(
        f"\nA drag frame (pose, rigid 0) is {ratio:.1f} times faster than one back-substitution "
        f"of 3 columns; the goal is {GOAL:.0f}."
    )


if __name__ == "__main__":
    main()
