"""What reading and writing files costs: `python -m benchmarks.speed.files [VERTICES ...]`."""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from benchmarks.machine import peak_memory
from benchmarks.speed.__main__ import Answer, apart
from benchmarks.tables import table
from solver import Mesh, load_mesh
from solver.types import FloatArray, IntArray

SIZES = 1_000, 10_000, 100_000, 1_000_000, 4_000_000
SUFFIXES = ".obj", ".off", ".ply", ".stl", ".glb"
HEAD = "format", "vertices", "file, MB", "read, s", "read, MB", "written, s", "written, MB"


def sheet(count: int) -> tuple[FloatArray, IntArray]:
    """A wavy sheet of about `count` vertices (n, 3) and twice as many triangles."""
    side = round(count**0.5)
    u, v = (x.ravel() for x in np.meshgrid(*[np.linspace(0, 1, side)] * 2))
    i = np.arange(side * side).reshape(side, side)
    a, b, c, d = (x.ravel() for x in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
    V = np.stack([u, v, np.sin(6 * u) * np.cos(5 * v)], axis=1)
    return V, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def write_source(path: Path, count: int) -> None:
    """The sheet; an OBJ as exporters write it, with texture coordinates and normals."""
    V, F = sheet(count)
    if path.suffix != ".obj":
        Mesh.from_arrays(V, F).save(path, V)
        return
    n = len(V)
    with path.open("wb") as stream:
        stream.write(b"v %.6f %.6f %.6f\n" * n % tuple(V.ravel().tolist()))
        stream.write(b"vt %.6f %.6f\n" * n % tuple(V[:, :2].ravel().tolist()))
        stream.write(b"vn %.6f %.6f 0.6\n" * n % tuple(V[:, 1:].ravel().tolist()))
        corners = np.repeat(F.ravel() + 1, 3).tolist()
        stream.write(b"f %d/%d/%d %d/%d/%d %d/%d/%d\n" * len(F) % tuple(corners))


def measure(path: Path) -> list[str]:
    """Seconds of the processor and peak megabytes to read a file and to write it, all moved."""
    # What the interpreter and the libraries hold is no part of it.
    before = peak_memory() or 0.0
    reading, mesh = _seconds(lambda: load_mesh(path))
    read_peak = (peak_memory() or 0.0) - before
    x, y, z = mesh.vertices.T
    X = np.stack([x * np.cos(y) - z * np.sin(y), y, x * np.sin(y) + z * np.cos(y)], axis=1)
    writing, _ = _seconds(lambda: mesh.save(path, X))
    written_peak = (peak_memory() or 0.0) - before
    size = path.stat().st_size
    return [
        *(path.suffix, f"{len(X):,}", f"{size / 1e6:.1f}"),
        *(f"{reading:.2f}", f"{read_peak / 1e6:.0f}"),
        *(f"{writing:.2f}", f"{written_peak / 1e6:.0f}"),
    ]


def _seconds(call: Callable[[], Answer]) -> tuple[float, Answer]:
    start = time.process_time()
    result = call()
    return time.process_time() - start, result


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.speed.files", description=__doc__)
    parser.add_argument("sizes", type=int, nargs="*", default=SIZES, metavar="VERTICES")
    options = parser.parse_args(arguments)
    rows = []
    with TemporaryDirectory() as folder:
        for suffix in SUFFIXES:
            for count in options.sizes:
                path = Path(folder) / f"sheet{suffix}"
                apart(write_source, path, count)
                rows.append(apart(measure, path))
                path.unlink()
    print(table(HEAD, rows))


if __name__ == "__main__":
    main()
