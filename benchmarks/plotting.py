"""Plots as SVG: the same data give the same file. Needs benchmarks/requirements.txt."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def load_pyplot(salt: str) -> Any:
    """matplotlib.pyplot, None where it is missing.

    salt: of the names inside the file.
    """
    try:
        import matplotlib
    except ImportError:
        return None
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = salt
    from matplotlib import pyplot

    return pyplot


def save(figure: Any, path: Path) -> None:
    """Write the figure, without the date, and forget it."""
    from matplotlib import pyplot

    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)
