"""What the program remembers between runs: the size of its interface, its window, recent files.

They belong to the person, not to a document. A file of them that cannot be understood is ignored,
with one line, and left as it is: nothing is written over what may be mended.
"""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from platformdirs import user_config_path

from app.model import schema
from app.model.settings import is_number
from solver.errors import SolverError
from solver.storage import read_bytes, write_atomically

PROGRAM = "surface-deformation"
PLACE = "SURFACE_DEFORMATION_PREFERENCES"  # an environment variable with another path
SMALLEST, LARGEST = 0.5, 4.0  # of the interface
LONGEST = 3600  # seconds between two autosaves


@dataclass(frozen=True)
class Preferences:
    """interface_scale: how large the interface is drawn, None as the screen asks.

    window: width and height of the window when it was last closed, None before that.
    dialogs: whether the system's own dialogs are used.
    recent: paths of files opened or saved, the last first.
    autosave: after how many seconds unsaved changes are kept.
    """

    interface_scale: float | None = None
    window: tuple[int, int] | None = None
    dialogs: bool = True
    recent: tuple[str, ...] = ()
    autosave: float = 60.0


def _pair(value: Any, where: str) -> tuple[int, int]:
    if not isinstance(value, list) or len(value) != 2 or not all(_is_length(v) for v in value):
        raise schema.refuse(where, "a width and a height", value)
    return value[0], value[1]


def _is_length(value: Any) -> bool:
    return type(value) is int and 0 < value < 100_000


_size = schema.that(
    lambda v: is_number(v) and SMALLEST <= v <= LARGEST, f"a number from {SMALLEST} to {LARGEST}"
)
_pause = schema.that(
    lambda v: is_number(v) and 0 < v <= LONGEST, f"a number of seconds, above 0 and up to {LONGEST}"
)
_texts = schema.list_of(schema.text)
CHECKS: dict[str, schema.Check] = {
    "interface_scale": lambda v, where: None if v is None else _size(v, where),
    "window": lambda v, where: None if v is None else _pair(v, where),
    "dialogs": schema.that(lambda v: isinstance(v, bool), "true or false"),
    "autosave": _pause,
    "recent": lambda v, where: tuple(_texts(v, where)),
}


class PreferencesFile:
    """The preferences of a person, read when they are asked for and written when they change.

    values: as they are now.  fault: why the file is ignored, one line, empty where it is not.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.values = Preferences()
        self.fault = ""
        self._read()

    def change(self, **changes: Any) -> None:
        """Change some, and write them all: whatever another window has written stays."""
        self._read()
        self.values = replace(self.values, **changes)
        if self.fault:
            return
        text = json.dumps(asdict(self.values), indent=1) + "\n"
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(self.path, text.encode())
        except (SolverError, OSError) as error:
            self.fault = f"preferences are not kept: {error}"

    def _read(self) -> None:
        if self.fault or not self.path.exists():
            return
        try:
            self.values = Preferences(**schema.fields(CHECKS)(_parsed(self.path), ""))
        except SolverError as error:
            self.fault = f"preferences are ignored, mend or remove the file: {self.path}: {error}"


def preferences_path() -> Path:
    """Where the platform keeps what programs remember for a person."""
    told = os.environ.get(PLACE)
    return Path(told) if told else user_config_path(PROGRAM, False) / "preferences.json"


def _parsed(path: Path) -> Any:
    return schema.parse(read_bytes(path))
