"""OBJ text with six decimals; five for the many pieces of one character."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assets.generator.character.seams import Part
from assets.generator.quads import QuadMesh, vertex_normals
from solver.types import FloatArray, IntArray

PROGRAM = "made by assets/generate.py"


def _lines(tag: str, rows: FloatArray, decimals: int = 6) -> list[str]:
    # Adding 0.0 turns a rounded -0.0 into 0.0.
    numbers = np.round(rows, decimals) + 0.0
    return [f"{tag} " + " ".join(f"{x:.{decimals}f}" for x in row) for row in numbers.tolist()]


def triangle_text(title: str, V: FloatArray, F: IntArray) -> str:
    """OBJ of a triangle mesh: a comment, `v` lines, `f` lines."""
    faces = [f"f {a} {b} {c}" for a, b, c in (F + 1).tolist()]
    return "\n".join((f"# {title}", f"# {PROGRAM}", *_lines("v", V), *faces, ""))


def quad_text(title: str, mesh: QuadMesh) -> str:
    """OBJ of a quad mesh: positions, UVs shared where equal, normals, a group per part."""
    uv, corner = np.unique(mesh.uv.reshape(-1, 2).round(6), axis=0, return_inverse=True)
    lines = [f"# {title}", f"# {PROGRAM}", "o dog", "# positions", *_lines("v", mesh.V)]
    lines += ["# one tile of the unit square for each block side", *_lines("vt", uv)]
    lines += ["# smooth normals", *_lines("vn", vertex_normals(mesh.V, mesh.Q))]
    corner = corner.reshape(-1, 4) + 1
    for number, name in enumerate(mesh.names):
        lines += [f"g {name}", f"usemtl {'dark' if name in ('ears', 'tail') else 'light'}", "s 1"]
        for q, t in zip(
            (mesh.Q + 1)[mesh.group == number], corner[mesh.group == number], strict=True
        ):
            lines.append("f " + " ".join(f"{v}/{k}/{v}" for v, k in zip(q, t, strict=True)))
    return "\n".join((*lines, ""))


def parts_text(title: str, parts: Sequence[Part]) -> str:
    """OBJ of named parts, an object and a material each; every vertex has one UV."""
    lines = [f"# {title}", f"# {PROGRAM}"]
    before = 1
    for part in parts:
        lines += [f"o {part.name}", *_lines("v", part.V, 5), *_lines("vt", part.uv, 4)]
        lines += [f"usemtl {part.material}", "s 1"]
        lines += [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in (part.F + before).tolist()]
        before += len(part.V)
    return "\n".join((*lines, ""))
