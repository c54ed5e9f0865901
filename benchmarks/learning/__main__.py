"""Real animals in real poses: `python -m benchmarks.learning [FOLDER]` writes docs/animals.md.

FOLDER holds animals, each in a folder of its own: NAME/NAME-reference.obj at rest and NAME-*.obj in
poses; by default ../shared/meshes. Softness is learned from every other pose and judged on the
rest. The text of the page stays; its table, between two marks, and its pictures are made anew.
CGAL's row is left out where CGAL or a compiler is missing.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path
from statistics import mean
from time import perf_counter

from benchmarks.cases.animals import Animal, animals
from benchmarks.cases.survey import MESHES
from benchmarks.learning.picture import draw
from benchmarks.programs import cgal
from benchmarks.tables import table
from solver import learn_softness
from solver.types import FloatArray

PAGE = Path(__file__).resolve().parents[2] / "docs" / "animals.md"
BEGIN, END = "<!-- measured -->\n", "<!-- end of measured -->"
LEVEL = 4
SETTLED = 1000
"""Iterations of CGAL's."""
MATERIALS = ("hinge", "clay")
UNIFORM, ARAP = f"this tool, uniform, level {LEVEL}", "libigl ARAP, 100 iterations"
Shapes = dict[str, dict[int, FloatArray]]


def others(animal: Animal, numbers: Iterable[int]) -> Shapes:
    """X (n, 3) of each pose, by method, without any softness."""
    shapes: Shapes = {"biharmonic": {}, ARAP: {}, UNIFORM: {}}
    for number in numbers:
        case = animal.case(number)
        shapes["biharmonic"][number] = case.harmonic()
        shapes[ARAP][number] = case.arap()
        shapes[UNIFORM][number] = case.deformer().pose(case.transforms, LEVEL)
        found = cgal.deform(case.V, case.F, *case.targets(), SETTLED)
        if found is not None:
            shapes.setdefault(f"CGAL SR-ARAP, {SETTLED} iterations", {})[number] = found.X
    return shapes


def study(animal: Animal) -> tuple[list[list[str]], dict[str, FloatArray], Shapes]:
    """Rows of the table, the softness learned with each material, and all shapes."""
    unseen = range(1, len(animal.poses), 2)
    shapes, learned, took = others(animal, unseen), dict[str, FloatArray](), dict[str, float]()
    examples = animal.poses[::2]
    for material in MATERIALS:
        start = perf_counter()
        parts = animal.V, animal.F, examples, animal.fixed, animal.handles
        learned[material] = s = learn_softness(*parts, material=material)
        name = f"learned, {material}"
        took[name] = perf_counter() - start
        shapes[name] = {}
        for number in unseen:
            case = animal.case(number, s)
            deformer = case.deformer(material=material)
            shapes[name][number] = deformer.pose(case.transforms, LEVEL)
    away = {name: mean(animal.away(k, found[k]) for k in unseen) for name, found in shapes.items()}
    rows = []
    for name, distance in away.items():
        shares = [f"{distance / away[other]:.2f}" for other in (UNIFORM, ARAP)]
        seconds = f"{took[name]:.1f}" if name in took else ""
        rows.append([animal.name, name, f"{distance:.2f}", *shares, seconds])
    return rows, learned, shapes


def main(folder: Path) -> None:
    found = list(animals(folder))
    if not found:
        print(f"There are no animals in {folder}: nothing to measure.")
        return
    rows = []
    for animal in found:
        more, learned, shapes = study(animal)
        rows += more
        if not draw(animal, learned, shapes, PAGE.parent / "animals"):
            print("No pictures: matplotlib (benchmarks/requirements.txt) is missing.")
    head = ["", "", "distance", "of uniform", "of ARAP", "seconds to learn"]
    text = table(head, rows)
    print(text)
    page = PAGE.read_text(encoding="utf-8")
    before, after = page[: page.index(BEGIN)], page[page.index(END) :]
    PAGE.write_text(f"{before}{BEGIN}\n{text}\n\n{after}", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else MESHES)
