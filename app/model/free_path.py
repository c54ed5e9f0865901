"""Names that no file has yet."""

from __future__ import annotations

import itertools
from pathlib import Path


def free_path(path: Path) -> Path:
    """`path`, or the same with the first number from 2 up, where no file is."""
    numbers = itertools.chain([""], (f"-{number}" for number in itertools.count(2)))
    paths = (path.with_name(f"{path.stem}{number}{path.suffix}") for number in numbers)
    return next(path for path in paths if not path.exists())
