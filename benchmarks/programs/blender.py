"""Blender's Laplacian Deform as a peer [Sorkine et al. 2004], where a Python has its module `bpy`.

That Python is this one, or the one that the environment variable BPY_PYTHON names: bpy comes with
versions of NumPy of its own.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from benchmarks.programs.result import Result
from solver.types import FloatArray, IntArray

SCRIPT = Path(__file__).with_name("in_blender.py")


def deform(
    V: FloatArray, F: IntArray, held: IntArray, goals: FloatArray, iterations: int
) -> Result | None:
    """V (n, 3), F (m, 3) with `held` vertices at `goals`; None where Blender cannot be had."""
    python = os.environ.get("BPY_PYTHON", sys.executable)
    with tempfile.TemporaryDirectory() as name:
        task, out = Path(name) / "task.npz", Path(name) / "out.npz"
        np.savez(task, V=V, F=F, held=held, goals=goals)
        command = [python, str(SCRIPT), str(task), str(iterations), str(out)]
        try:
            subprocess.run(command, capture_output=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            return None
        with np.load(out) as found:
            X = found["X"].astype(np.float64)
            return Result(X, float(found["bind"]), float(found["deformation"]))
