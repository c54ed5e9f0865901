"""Time against vertices, on logarithmic axes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from benchmarks.plotting import load_pyplot, save
from benchmarks.speed import peers, steps
from benchmarks.speed.steps import Result

OURS = (
    steps.BIND,
    steps.SOFTNESS,
    steps.HANDLE,
    steps.GRAB,
    steps.RIGID,
    steps.COARSE_HANDLE,
    steps.COARSE_SETTLED,
    steps.DRAG,
)
PEERS = (peers.PAPER, peers.PRECOMPUTE, peers.ARAP, peers.CGAL, peers.BLENDER, peers.HARMONIC)


def draw(results: Sequence[Result], path: Path) -> bool:
    """Write the plot; False where matplotlib, which benchmarks/requirements.txt has, is missing."""
    pyplot = load_pyplot("benchmarks")
    if pyplot is None:
        return False
    figure, axes = pyplot.subplots(figsize=(7, 7), layout="constrained")
    for names, style in ((OURS, "o-"), (PEERS, "s--")):
        for name in names:
            points = [(r.vertices, r.times[name]) for r in results if name in r.times]
            if points:  # a program may be missing, or too slow for every size
                axes.loglog(*zip(*points, strict=True), style, markersize=4, label=name)
    axes.set(xlabel="vertices", ylabel="seconds", title="Medians; dashed: other programs")
    axes.set_xticks(
        [r.vertices for r in results], [f"{r.vertices:,}" for r in results], minor=False
    )
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    figure.legend(loc="outside lower center", ncols=2, fontsize="small")
    save(figure, path)
    return True
