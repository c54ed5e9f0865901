"""Shape quality: `python -m benchmarks.quality` measures all cases and writes docs/quality.md.

The text of that page stays; its tables, between two marks, and its plots are made anew. The
survey's two cases need its data in ../shared/meshes/bs08 and are left out where they are missing,
so are CGAL's rows without CGAL (Debian's libcgal-dev) and a compiler, and Blender's without `bpy`.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from benchmarks.cases.assets import all_cases
from benchmarks.cases.case import Case
from benchmarks.cases.survey import PRIMO
from benchmarks.programs import blender, cgal
from benchmarks.quality.plots import draw
from benchmarks.quality.sweeps import TURNS, drag_rows, resolution_rows, turn_rows
from benchmarks.tables import table
from benchmarks.timing import seconds
from solver.measure.quality import Quality
from solver.types import FloatArray

PAGE = Path(__file__).resolve().parents[2] / "docs" / "quality.md"
BEGIN, END = "<!-- measured -->\n", "<!-- end of measured -->"
DEFAULT = 4
"""The level of `rigid` that is judged."""
LEVELS = (0, 1, 2, DEFAULT, 8, 60)
PROGRAMS = (
    ("CGAL SR-ARAP", cgal.deform, 10),
    ("CGAL SR-ARAP", cgal.deform, 1000),
    ("Blender's Laplacian Deform", blender.deform, 1),
    ("Blender's Laplacian Deform", blender.deform, 100),
)
"""Other programs with their usual iterations, and with so many that they have all but settled."""


def results(case: Case) -> Iterator[tuple[str, FloatArray, str]]:
    """Method, X, and milliseconds of ours."""
    for name, X in case.published.items():
        yield name, X, ""
    yield "libigl ARAP, 100 iterations", case.arap(), ""
    for name, deform, iterations in PROGRAMS:
        found = deform(case.V, case.F, *case.targets(), iterations)
        if found is not None:
            label = f"{name}, {iterations} iteration{'s' if iterations > 1 else ''}"
            yield label, found.X, f"{1000 * found.deformation:.0f}"
    yield "harmonic", case.harmonic(1), ""
    yield "biharmonic", case.harmonic(2), ""
    deformer = case.deformer()
    for rigid in LEVELS:
        X = deformer.pose(case.transforms, rigid)
        took = seconds(lambda level=rigid: deformer.pose(case.transforms, level), 5)  # type: ignore[misc]
        yield f"this tool, rigid {rigid}", X, f"{1000 * took:.1f}"


def case_table(case: Case) -> tuple[str, dict[str, Quality]]:
    """One row a method, and the numbers by method."""
    head = ["", "strain", "dihedral error", "volume", "broken"]
    head += ["share of the bend", "section"] if case.limb else []
    rows, known = [], {}
    for name, X, took in results(case):
        known[name] = m = case.quality(X)
        volume = "" if np.isnan(m.volume) else f"{m.volume:.3f}"
        row = [name, f"{m.strain:.3f}", f"{m.dihedral:.3f}", volume, str(m.broken)]
        if case.limb:
            fold = case.fold(X)
            row += [f"{100 * fold.share:.0f} %", f"{fold.section:.2f}"]
        rows.append([*row, took])
    return table([*head, "ms"], rows), known


def verdicts(case: Case, known: dict[str, Quality]) -> list[list[str]]:
    """Each goal with what was reached."""
    ours = known[f"this tool, rigid {DEFAULT}"]
    rows = []
    if PRIMO in known:
        primo = known[PRIMO]
        rows += [
            _verdict(case, "strain below PriMo's", ours.strain, primo.strain, -1),
            _verdict(case, "dihedral error", ours.dihedral, 1.5 * primo.dihedral, -1),
            _verdict(case, "volume", ours.volume, primo.volume - 0.05, 1),
        ]
    if case.limb:
        X = case.deformer().pose(case.transforms, DEFAULT)
        fold = case.fold(X)
        rows.append(_verdict(case, "share of the bend in the soft band", fold.share, 0.8, 1))
        rows.append(_verdict(case, "area of the elbow's section", fold.section, 0.75, 1))
    return rows


def _verdict(case: Case, what: str, reached: float, goal: float, sign: int) -> list[str]:
    met = sign * (reached - goal) >= 0
    limit = f"{'at least' if sign > 0 else 'at most'} {goal:.3f}"
    return [case.name, what, limit, f"{reached:.3f}", "yes" if met else "no"]


def measured(cases: list[Case]) -> str:
    """The page's tables."""
    parts, goals = [], []
    for case in cases:
        text, known = case_table(case)
        goals += verdicts(case, known)
        parts.append(f"### {case.name} ({len(case.V)} vertices)\n\n{text}\n")
    head = ["case", "goal", "limit", f"rigid {DEFAULT}", "met"]
    return "\n".join(
        [
            f"### Goals\n\n{table(head, goals)}\n",
            *parts,
            f"### Resolution\n\nThe cylinder's bend at rigid {DEFAULT}:\n",
            table(["vertices", "strain", "volume", "ms a round"], resolution_rows(DEFAULT)) + "\n",
            f"### Large turns\n\nBroken triangles, rigid {DEFAULT} / ARAP:\n",
            table(["", *(f"{degrees} degrees" for degrees in TURNS)], turn_rows(DEFAULT)) + "\n",
            "### Drags\n\n" + DRAGS,
            table(["", "up to 150 degrees", "beyond", "broken, ours / ARAP"], drag_rows(DEFAULT)),
        ]
    )


DRAGS = """Half circles through `orient`, around the place where the limb is fixed, at 0.95 and 0.6
of its length. The largest step of the surface (of the handle) for a step of the target, and the
pose with the most broken triangles:
"""


def main() -> None:
    cases = list(all_cases())
    text = measured(cases)
    print(text)
    if not draw(cases, PAGE.parent / "quality"):
        print("\nNo plots: matplotlib (benchmarks/requirements.txt) is missing.")
    page = PAGE.read_text(encoding="utf-8")
    before, after = page[: page.index(BEGIN)], page[page.index(END) :]
    PAGE.write_text(f"{before}{BEGIN}\n{text}\n\n{after}", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
