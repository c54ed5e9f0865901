"""What a bind takes of memory, said before it is tried: a machine without any left is lost."""

from __future__ import annotations

from pathlib import Path

from solver.errors import SolverError

# Peaks with rounds at level 4: 14 GB for a million vertices solved exactly, growing a little faster
# than linearly; 2.9 GB with coarse frames. [docs/scaling.md]
EXACT_BYTES, EXACT_VERTICES, GROWTH = 14.0e9, 1_000_000, 1.05
COARSE_BYTES = 3_200  # a vertex
ALWAYS = 50_000  # vertices: as many are solved wherever the program runs at all


class OutOfMemory(SolverError):
    """A bind does not fit into the memory that is free."""


def check_memory(vertex_count: int, coarse: int | None) -> None:
    """Raises OutOfMemory where a bind of so many vertices would not fit.

    coarse: see Deformer. Where the system does not say what is free, nothing is refused.
    """
    free = free_bytes()
    needed = bind_bytes(vertex_count, coarse)
    if vertex_count <= ALWAYS or free is None or needed <= free:
        return
    cure = "close other programs" if coarse else "solve it with coarse frames instead (not exact)"
    raise OutOfMemory(
        f"binding {vertex_count:,} vertices takes about {needed / 1e9:.1f} GB of memory, "
        f"{free / 1e9:.1f} GB are free: {cure}"
    )


def bind_bytes(vertex_count: int, coarse: int | None) -> float:
    """About how many bytes a bind takes at its peak."""
    if coarse is not None and coarse < vertex_count:
        return COARSE_BYTES * vertex_count
    return float(EXACT_BYTES * (vertex_count / EXACT_VERTICES) ** GROWTH)


def free_bytes(information: Path = Path("/proc/meminfo")) -> float | None:
    """Bytes of memory that programs can still have; None where the system does not say."""
    try:
        lines = information.read_text(encoding="ascii").splitlines()
    except OSError:
        return None
    amounts = (line.split() for line in lines if line.startswith("MemAvailable:"))
    return next((1024.0 * float(words[1]) for words in amounts), None)
