"""Running the command line, and the small mesh and session that its tests work on."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from app.__main__ import main
from solver.geometry.motions import motion, rotation
from solver.types import FloatArray
from tests.app.person import slab

ROOT = Path(__file__).resolve().parents[2]
# The graphics library cannot be imported: as on a machine that does not have it.
WITHOUT_GRAPHICS = (
    "import sys; sys.modules['polyscope'] = None; "
    "from app.__main__ import main; sys.exit(main(sys.argv[1:]))"
)
HANDLE = list(range(90, 95))
FIXED = list(range(5))


def run(*words: str | Path, code: str = "") -> subprocess.CompletedProcess[str]:
    """`python -m app WORDS` without a display, or a program of its own in place of `-m app`."""
    program = ["-c", code] if code else ["-m", "app"]
    environment = {k: v for k, v in os.environ.items() if not k.endswith("DISPLAY")}
    command = [sys.executable, "-P", *program, *map(str, words)]
    return subprocess.run(
        command,
        env=environment | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


def refused(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """The one line on stderr of a command that ends with exit code 2."""
    code: object
    try:
        code = main(words)
    except SystemExit as end:
        code = end.code
    output = capsys.readouterr()
    assert code == 2
    assert output.out == ""
    assert re.fullmatch(r"python -m app[^\n]*: [^\n]+\n", output.err), output.err
    return output.err


def write_bar() -> None:
    """bar.obj and bar.json, a session that turns its end, in the working directory."""
    mesh = slab(20, 4, 2.0)
    mesh.save("bar.obj", mesh.vertices)
    session()


def turn() -> FloatArray:
    """A quarter turn about z and a shift."""
    return motion(rotation([0, 0, 1], 90), [18.0, 2.0, 1.0])


def session(name: str = "bar.json", **changes: Any) -> None:
    """Write a session file on bar.obj with some keys changed."""
    handle = {"name": "end", "vertices": HANDLE, "transform": turn().tolist()}
    data = {
        "format": "surface-deformation-session",
        "version": 1,
        "mesh": {"path": "bar.obj"},
        "fixed": FIXED,
        "handles": [handle],
        **changes,
    }
    Path(name).write_text(json.dumps(data))


def write(name: str, data: str | bytes) -> None:
    """Write a file, text as UTF-8."""
    Path(name).write_bytes(data.encode() if isinstance(data, str) else data)
