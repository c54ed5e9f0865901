"""CGAL's smoothed-rotation ARAP as a peer: a small program, compiled where CGAL is installed."""

from __future__ import annotations

import hashlib
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from benchmarks.programs.result import Result
from solver import Mesh
from solver.types import FloatArray, IntArray

SOURCE = Path(__file__).with_name("cgal.cpp")
COMPILE = ("g++", "-std=c++17", "-O3", "-DNDEBUG", "-DCGAL_EIGEN3_ENABLED", "-I/usr/include/eigen3")


@cache
def program() -> Path | None:
    """The compiled program, None where CGAL (Debian's libcgal-dev) or a compiler is missing."""
    # It takes half a minute to compile: the processes of one benchmark, and the next, share it.
    known = hashlib.sha256(SOURCE.read_bytes()).hexdigest()[:16]
    compiled = Path(tempfile.gettempdir()) / f"surface-deformation-cgal-{known}"
    if compiled.exists():
        return compiled
    with tempfile.TemporaryDirectory(dir=compiled.parent) as folder:
        made = Path(folder) / "deform"
        command = [*COMPILE, str(SOURCE), "-o", str(made), "-lgmp", "-lmpfr"]
        try:
            done = subprocess.run(command, capture_output=True, check=False)
        except OSError:
            return None
        return made.replace(compiled) if done.returncode == 0 else None


def deform(
    V: FloatArray, F: IntArray, held: IntArray, goals: FloatArray, iterations: int
) -> Result | None:
    """V (n, 3), F (m, 3) with `held` vertices at `goals`; None where CGAL cannot be had.

    None too for a mesh that CGAL does not take: it must be manifold.
    """
    compiled = program()
    if compiled is None:
        return None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        Mesh.from_arrays(V, F).save(folder / "mesh.off", V)
        lines = np.column_stack([held, goals])
        np.savetxt(folder / "held.txt", lines, fmt=["%d", "%.17g", "%.17g", "%.17g"])
        files = [str(folder / file) for file in ("mesh.off", "held.txt")]
        command = [str(compiled), *files, str(iterations), str(folder / "out.txt")]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return None
        preprocessing, iteration = map(float, done.stdout.split())
        X = np.loadtxt(folder / "out.txt")
        return Result(X, preprocessing, iterations * iteration)
