"""Makes figures.md and its pictures: `python -m docs.make_figures`. Needs no display."""

from __future__ import annotations

from pathlib import Path

from app.bundled import DEFAULT_MESH
from app.figures import compute
from app.figures.arm import Arm
from app.figures.measures import ArmMeasures
from app.figures.report import markdown
from app.figures.stage import draw
from solver import load_mesh

DOCS = Path(__file__).resolve().parent


def main() -> None:
    """The page for readers of the repository, beside what `figures` writes for anybody."""
    arm = Arm(load_mesh(DEFAULT_MESH))
    found = compute(arm)
    draw(found, DOCS / "images")
    page = markdown(found, ArmMeasures(arm).at_rest(), "images/")
    (DOCS / "figures.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
