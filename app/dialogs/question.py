"""What a dialog asks for, and what is answered, as data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Purpose = Literal[
    "open", "learn", "add pose", "save", "export", "export poses", "turntable", "record"
]
READS = "open", "learn", "add pose"


@dataclass(frozen=True)
class Kind:
    """Files of one kind: what they are called, and their suffixes with a dot."""

    label: str
    suffixes: tuple[str, ...]

    @property
    def patterns(self) -> list[str]:
        """As dialogs want them, which heed case."""
        spelled = (spelling for s in self.suffixes for spelling in (s, s.upper()))
        return [f"*{suffix}" for suffix in spelled]


@dataclass(frozen=True)
class Question:
    """purpose: those of READS ask for a file that is there, the others for where to write one.

    path: the file that is proposed, or the folder to begin in.  kinds: the first is shown first.
    """

    purpose: Purpose
    title: str
    path: Path
    kinds: tuple[Kind, ...]

    @property
    def saves(self) -> bool:
        """Whether a file is to be written: a dialog asks before one that is there is replaced."""
        return self.purpose not in READS


@dataclass(frozen=True)
class Answer:
    """path: absolute; None where the person cancelled."""

    question: Question
    path: Path | None
