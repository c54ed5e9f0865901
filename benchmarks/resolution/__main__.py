"""Whether softness and bending length mean the same on every mesh: a limb at many resolutions.

`python -m benchmarks.resolution [-o FILE.svg]`: tables as Markdown, and a plot with matplotlib.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from benchmarks.cases.limbs import OUTLINES, limb
from benchmarks.plotting import load_pyplot, save
from benchmarks.resolution.curves import BEND, HINGE, MATERIALS, Curve, curves, measure
from benchmarks.tables import table

# Cells four times as long as wide, both ways.
SLENDER = {"4:1 across": (128, 24), "4:1 along": (32, 88)}
OUTPUT = Path(__file__).resolve().parents[2] / "docs" / "images" / "resolution.svg"


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
    pyplot = load_pyplot("benchmarks")
    if pyplot is None:
        return False
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
    save(figure, path)
    return True


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.resolution", description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=OUTPUT, metavar="FILE.svg")
    output = parser.parse_args().output
    found = {shape: curves(shape) for shape in OUTLINES}
    for shape, of_shape in found.items():
        print(report(shape, of_shape))
    if not draw(found, output):
        print("No plot: matplotlib is missing (benchmarks/requirements.txt).")


if __name__ == "__main__":
    main()
