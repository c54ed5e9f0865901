"""What a measurement ran on, and how much memory it took."""

from __future__ import annotations

import os
import platform
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np
import scipy

from solver.factor import BACKENDS

PACKAGES = "numpy", "scipy", "libigl", "cvxopt", "rslab"


def peak_memory() -> float | None:
    """Bytes of the most memory this process has held; None where the system does not say."""
    if sys.platform == "win32":
        return None
    import resource  # not on Windows

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(peak if sys.platform == "darwin" else 1024 * peak)


def description() -> str:
    """The machine and the versions, a Markdown list."""
    lines = [
        f"{_processor()}, {_cores()} cores, {platform.system()} {platform.machine()}{_load()}",
        f"Python {platform.python_version()}, "
        + ", ".join(f"{name} {_version(name)}" for name in PACKAGES),
        f"factorisation: {_backend()}; BLAS: NumPy with {_blas(np)}, SciPy with {_blas(scipy)};"
        " one thread, as in the window's solver process",
    ]
    return "\n".join(f"- {line}" for line in lines)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown processor"


def _cores() -> int:
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _load() -> str:
    if sys.platform == "win32":
        return ""
    return f", load {os.getloadavg()[0]:.1f} before the run"


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "missing"


def _backend() -> str:
    for package in ("cvxopt", "kvxopt"):
        if _version(package) != "missing":
            return f"CHOLMOD and OpenBLAS as they come with {package} {_version(package)}"
    return BACKENDS[0].name


def _blas(module: Any) -> str:
    blas = module.show_config(mode="dicts")["Build Dependencies"]["blas"]
    return f"{blas['name']} {blas['version']}"
