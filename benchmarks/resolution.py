"""Whether softness and bending length mean the same on every mesh: a limb at many resolutions.

`python -m benchmarks.resolution [-o FILE.svg]`: tables as Markdown, and a plot with matplotlib.
A limb fixed at one end is bent by its other end; how much of the bend lies within its soft band?
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.limbs import SECTIONS, Limb, limb
from benchmarks.timing import table
from solver import Deformer
from solver.types import FloatArray

SIZES = (32, 20), (64, 44), (128, 88)  # (along, around)
FINEST = 192, 128
TRIANGULATIONS = "right", "alternating", "irregular"
# Cells four times as long as wide, both ways.
SLENDER = {"4:1 across": (128, 24), "4:1 along": (32, 88)}
BEND = 60.0
GRABBED = np.array([3.5, 0.0, 0.0])
# (material, softness of the band's middle)
HINGE = tuple(("hinge", s) for s in (0.0, 0.25, 0.5, 0.75, 1.0))
MATERIALS = (*HINGE, ("paper", 1.0), ("clay", 1.0))
OUTPUT = Path(__file__).resolve().parents[1] / "docs" / "images" / "resolution.svg"


@dataclass(frozen=True)
class Curve:
    """What one mesh does, a value for each of MATERIALS.

    linear, rigid: percent of the bend within the band, the tip turned by `pose` at rigid 0 and 1.
    turn: degrees by which the tip turns of itself when `orient` carries it around.
    dragged: percent of that turn within the band.
    """

    name: str
    vertices: int
    linear: FloatArray
    rigid: FloatArray
    turn: FloatArray
    dragged: FloatArray


def bent(angle: float = BEND) -> FloatArray:
    """(4, 4) the turn about z through the middle of the limb."""
    T = np.eye(4)
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    T[:2, :2] = [[c, -s], [s, c]]
    return T


def measure(name: str, one: Limb, bending_length: float = 0.01) -> Curve:
    """Bend a limb with every material."""
    deformer = Deformer(one.V, one.F, one.root, [one.tip], bending_length=bending_length)
    rows = []
    for material, softness in MATERIALS:
        deformer = deformer.rebind(softness=softness * one.softness, material=material)
        T = bent()
        shares = [one.share(deformer.pose([T], rigid), BEND) for rigid in (0, 1)]
        T = deformer.orient(0, GRABBED, T[:3, :3] @ GRABBED, [np.eye(4)])
        turn = float(np.degrees(np.arctan2(T[1, 0], T[0, 0])))
        rows.append([*shares, turn, one.share(deformer.pose([T]), turn)])
    return Curve(name, len(one.V), *np.transpose(rows))


def curves(shape: str) -> list[Curve]:
    """Every triangulation at every size; the last is the reference."""
    meshes = [(t, *size) for size in SIZES for t in TRIANGULATIONS]
    meshes.append(("alternating", *FINEST))
    return [measure(t, limb(shape, t, *size)) for t, *size in meshes]


def deviations(found: list[Curve], reference: Curve) -> str:
    """How far curves lie from the reference at most: percent of it, degrees for the turn."""
    parts = []
    for what in ("linear", "rigid", "dragged", "turn"):
        values, goal = np.array([getattr(c, what) for c in found]), getattr(reference, what)
        away = values - goal if what == "turn" else 100 * (values / goal - 1)
        unit = " degrees" if what == "turn" else " %"
        parts.append(f"{what} {away.min():+.1f} to {away.max():+.1f}{unit}")
    return ", ".join(parts)


def rows(found: list[Curve]) -> str:
    head = ["triangles", "vertices", *(f"{material} {s:g}" for material, s in MATERIALS)]
    shares, turns = [], []
    for c in found:
        start = [c.name, str(c.vertices)]
        pairs = zip(c.linear, c.rigid, strict=True)
        shares.append([*start, *(f"{a:.1f} / {b:.1f}" for a, b in pairs)])
        pairs = zip(c.turn, c.dragged, strict=True)
        turns.append([*start, *(f"{a:.0f}, {b:.1f}" for a, b in pairs)])
    return (
        f"Percent of a bend of {BEND:.0f} degrees within the band, rigid 0 / rigid 1:\n\n"
        f"{table(head, shares)}\n\nThe tip carried around by {BEND:.0f} degrees with `orient`: "
        f"its turn in degrees, percent of it within the band:\n\n{table(head, turns)}\n"
    )


def report(shape: str, found: list[Curve]) -> str:
    reference = found[-1]
    parts = [f"## A {shape}\n", rows(found), "Against the finest mesh:\n"]
    for n in sorted({c.vertices for c in found if c is not reference}):
        same = [c for c in found if c.vertices == n]
        parts.append(f"* {n} vertices: {deviations(same, reference)}")
    slender = [measure(name, limb(shape, "right", *n)) for name, n in SLENDER.items()]
    parts += [f"\n### Slender triangles on the {shape}\n", rows(slender)]
    parts.append(f"Against the finest mesh: {deviations(slender, reference)}\n")
    return "\n".join(parts)


def draw(found: dict[str, list[Curve]], path: Path) -> bool:
    """Share against softness, a line for each mesh; False where matplotlib is missing."""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "benchmarks"  # the same data give the same file
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, len(found), figsize=(9, 4), sharey=True, layout="constrained")
    softness = [s for _, s in HINGE]
    for (shape, of_shape), axis in zip(found.items(), axes, strict=True):
        for c in of_shape:
            label = f"{c.name}, {c.vertices}"
            axis.plot(softness, c.linear[: len(HINGE)], "o-", markersize=3, lw=1, label=label)
        axis.set(xlabel="softness (hinge)", title=shape, ylim=(0, None))
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("percent of the bend within the band")
    axes[-1].legend(fontsize="x-small")
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)
    return True


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.resolution", description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=OUTPUT, metavar="FILE.svg")
    output = parser.parse_args().output
    found = {shape: curves(shape) for shape in SECTIONS}
    for shape, of_shape in found.items():
        print(report(shape, of_shape))
    if not draw(found, output):
        print("No plot: matplotlib is missing (benchmarks/requirements.txt).")


if __name__ == "__main__":
    main()
