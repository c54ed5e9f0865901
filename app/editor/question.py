"""What the program asks a person before it goes on, as data."""

from __future__ import annotations

from dataclasses import dataclass

from app.editor.commands import Command


@dataclass(frozen=True)
class Answer:
    """What a button says, and what is done where it is pressed. None: nothing."""

    label: str
    command: Command | None = None


CANCEL = Answer("Cancel")


@dataclass(frozen=True)
class Question:
    """A text of one line or a few, and up to three answers of distinct labels.

    Enter gives the first answer, Esc the last, which loses nothing.
    """

    text: str
    answers: tuple[Answer, ...] = (CANCEL,)


class Asks(Exception):
    """Raised by an action that has to ask first and has done nothing yet. question: what."""

    def __init__(self, question: Question) -> None:
        super().__init__(question.text)
        self.question = question
