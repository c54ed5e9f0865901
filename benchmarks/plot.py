"""Time against vertices, on logarithmic axes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from benchmarks import peers, steps
from benchmarks.steps import Result

OURS = steps.BIND, steps.SOFTNESS, steps.HANDLE, steps.GRAB, steps.RIGID, steps.DRAG
PEERS = peers.PAPER, peers.PRECOMPUTE, peers.ARAP, peers.HARMONIC


def draw(results: Sequence[Result], path: Path) -> bool:
    """Write the plot; False where matplotlib, which benchmarks/requirements.txt has, is missing."""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "benchmarks"  # the same data give the same file
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7, 7), layout="constrained")
    for names, style in ((OURS, "o-"), (PEERS, "s--")):
        for name in names:
            points = [(r.vertices, r.times[name]) for r in results if name in r.times]
            axes.loglog(*zip(*points, strict=True), style, markersize=4, label=name)
    axes.set(xlabel="vertices", ylabel="seconds", title="Medians; dashed: other programs")
    axes.set_xticks(
        [r.vertices for r in results], [f"{r.vertices:,}" for r in results], minor=False
    )
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    figure.legend(loc="outside lower center", ncols=2, fontsize="small")
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)
    return True
