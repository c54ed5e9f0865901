"""The documents: what they link to and the files they name are there, and made by the program."""

from __future__ import annotations

import re
from fnmatch import fnmatch
from pathlib import Path

import pytest

from app.figures import FILES as FIGURES
from benchmarks.resolution.__main__ import OUTPUT as RESOLUTION
from docs.make_pictures import MAKERS
from docs.make_pieces import PICTURES as PIECES

ROOT = Path(__file__).resolve().parents[1]
DOCUMENTS = sorted(
    path
    for folder in (".", "docs", "examples", "assets", "benchmarks")
    for path in (ROOT / folder).glob("*.md")
)
LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")
PART = re.compile(r"\]\(([^)#:]*)#([^)]+)\)")
# `app/window/panel/`, `solver/setup.py`: with a folder, so that it can be looked up.
NAMED = re.compile(r"`((?:app|solver|tests|docs|examples|assets|benchmarks)/[\w./-]*)`")

PICTURES = sorted(p for p in (ROOT / "docs").rglob("*") if p.suffix in {".png", ".svg", ".gif"})
MADE = {*(name for pictures in MAKERS for name in pictures), *PIECES, *FIGURES, RESOLUTION.name}
PAST = "resolution-before.svg"  # by what the program was once, to compare with


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_documents_name_files_that_are_there(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    missing = {link for link in LINK.findall(text) if not (path.parent / link).exists()}
    missing |= {name for name in NAMED.findall(text) if not (ROOT / name).exists()}
    assert not missing


def test_every_picture_is_seen_in_a_document() -> None:
    seen = {
        (path.parent / link).resolve()
        for path in DOCUMENTS
        for link in LINK.findall(path.read_text(encoding="utf-8"))
    }
    assert PICTURES
    assert not [str(path) for path in PICTURES if path not in seen]


def test_every_picture_is_made_by_the_program_and_every_maker_has_made_its_own() -> None:
    there = {path.name for path in PICTURES if path.parent.name == "images"}
    assert not [n for n in there - {PAST} if not any(fnmatch(n, made) for made in MADE)]
    pictures = (made for made in MADE if not made.startswith("figures."))
    assert not [m for m in pictures if not any(fnmatch(n, m) for n in there)]


def test_the_parts_of_a_document_that_links_lead_to_are_there() -> None:
    """`user.md#the-mirror`, `#warnings`: headings as they are written in addresses."""
    missing = []
    for path in DOCUMENTS:
        for link, part in PART.findall(path.read_text(encoding="utf-8")):
            target = path.parent / link if link else path
            if target.suffix == ".md" and part not in parts(target):
                missing.append(f"{path.name}: {link}#{part}")
    assert not missing


def parts(path: Path) -> set[str]:
    headings = re.findall(r"^#+ (.+)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}
