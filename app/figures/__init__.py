"""The paper's figures 4 to 12 and what it could not do, on the default mesh, with numbers."""

from __future__ import annotations

from pathlib import Path

from app.bundled import DEFAULT_MESH
from app.figures.arm import Arm
from app.figures.beyond import beyond_the_paper
from app.figures.figure import Figure
from app.figures.measures import ArmMeasures
from app.figures.paper import of_the_paper
from app.figures.report import markdown, record
from app.figures.stage import draw
from app.graphics import GraphicsError
from app.telling import tell
from solver import load_mesh
from solver.storage import write_atomically

FILES = "figures.json", "figures.md", "figure-*.png"


def figures(folder: Path) -> None:
    """Save figures.json, figures.md and a PNG for each figure. Raises SolverError.

    Where no graphics library can be used, the pictures are left out and it says so.
    """
    arm = Arm(load_mesh(DEFAULT_MESH))
    found = compute(arm)
    pictures: str | None = ""
    try:
        draw(found, folder)
    except GraphicsError as error:
        tell(f"no pictures: {error}", error=True)
        pictures = None
    rest = ArmMeasures(arm).at_rest()
    write_atomically(folder / "figures.json", record(found, rest).encode())
    write_atomically(folder / "figures.md", markdown(found, rest, pictures).encode())
    tell(f"{folder / 'figures.json'}, {folder / 'figures.md'}: saved")


def compute(arm: Arm) -> list[Figure]:
    """All figures with their captions and numbers, nothing drawn. Raises SolverError."""
    return [*of_the_paper(arm), *beyond_the_paper(arm)]
