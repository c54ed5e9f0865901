"""The documents: what they link to and the files they name are there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
DOCUMENTS = sorted(
    path
    for folder in (".", "docs", "examples", "assets", "benchmarks")
    for path in (ROOT / folder).glob("*.md")
)
LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")
# `app/window/panel/`, `solver/setup.py`: with a folder, so that it can be looked up.
NAMED = re.compile(r"`((?:app|solver|tests|docs|examples|assets|benchmarks)/[\w./-]*)`")


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_documents_name_files_that_are_there(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    missing = {link for link in LINK.findall(text) if not (path.parent / link).exists()}
    missing |= {name for name in NAMED.findall(text) if not (ROOT / name).exists()}
    assert not missing
