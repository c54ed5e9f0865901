"""The figures as JSON for programs and as Markdown for people."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from app.bundled import DEFAULT_MESH
from app.figures.figure import Figure
from app.figures.measures import MEANING, Numbers

INTRODUCTION = """\
# Figures

The figures of the paper from 4 to 12 on the mannequin's arm, and what the paper could not do
(13 to 15). Pictures, captions and numbers come from one run of
`python -m app figures -o DIR`, which writes the numbers to `figures.json` too.

Figures 7 to 12 use the paper's own, linear method (`rigid=0`). The hand turns about a point near
the outer side of the elbow, as in the paper, so that the elbow is compressed. Two settings are
chosen so that the paper's claims can be seen. The bending length is 0.1 diagonals, several radii of
the arm, as in the paper; at the tool's 0.01 the paper's material changes next to nothing. And
handles hold their orientation, where the paper holds positions alone: at this bending length that
leaves a kink at the border of a handle, which has nothing to do with the material.
"""


def record(figures: Sequence[Figure], rest: Numbers) -> str:
    """Everything but the pictures, as JSON text."""
    data = {
        "mesh": DEFAULT_MESH.name,
        "rest": rest,
        "meaning": MEANING,
        "figures": [_entry(figure) for figure in figures],
    }
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def _entry(figure: Figure) -> dict[str, Any]:
    return {
        "number": figure.number,
        "title": figure.title,
        "caption": figure.caption,
        "picture": figure.picture,
        "settings": figure.settings,
        "numbers": figure.numbers,
    }


def markdown(figures: Sequence[Figure], rest: Numbers, pictures: str | None) -> str:
    """A page of pictures and captions, and a table of numbers.

    pictures: what goes before a picture's file name ("images/"), None without pictures.
    """
    parts = [INTRODUCTION]
    for figure in figures:
        parts.append(f"## Figure {figure.number.lstrip('0')}: {figure.title.lower()}\n")
        if pictures is not None:
            parts.append(f"![{figure.title}]({pictures}{figure.picture})\n")
        parts.append(f"{figure.caption}\n")
    parts += [_table([f for f in figures if MEANING.keys() <= f.numbers.keys()]), _meaning(rest)]
    return "\n".join(parts)


def _table(figures: Sequence[Figure]) -> str:
    head = ["", *(figure.number.lstrip("0") for figure in figures)]
    rows = [head, ["---"] * len(head)]
    for name in MEANING:
        rows.append([name.replace("_", " "), *(f"{f.numbers[name]:.3g}" for f in figures)])
    lines = "\n".join(f"| {' | '.join(row)} |" for row in rows)
    return f"## Numbers\n\nBy figure; sizes are shares of the rest shape.\n\n{lines}\n"


def _meaning(rest: Numbers) -> str:
    lines = [f"* **{name.replace('_', ' ')}**: {text}." for name, text in MEANING.items()]
    sizes = ", ".join(f"{name.replace('_', ' ')} {value:.3g}" for name, value in rest.items())
    return "\n".join([*lines, "", f"At rest, in units of the file: {sizes}.", ""])
