"""What is said to a person: every line readable and of a bearable length, wherever it goes."""

from __future__ import annotations

import os
import sys
from typing import TextIO

MOST = 800  # characters of a line: ten rows of a terminal


def readable(text: str) -> str:
    r"""One line that shows every character, or its number where it would not be seen.

    Names and paths may hold line breaks, the codes that colour a terminal, those that turn the
    direction of a text, bytes that are no text. The middle of a long one is left out.

    >>> from app.telling import readable
    >>> print(readable("two\nlines \x1b[31m"))
    two\nlines \x1b[31m
    """
    if len(text) > MOST:  # before as well: a line of megabytes takes no time
        text = _shortened(text)
    if text.isprintable():
        return text
    return _shortened("".join(c if c.isprintable() else ascii(c)[1:-1] for c in text))


def counted(number: int, noun: str) -> str:
    """So many of something, in words.

    >>> from app.telling import counted
    >>> counted(1, "kept pose"), counted(1200, "fixed vertex")
    ('1 kept pose', '1,200 fixed vertices')
    """
    if number == 1:
        return f"1 {noun}"
    plural = f"{noun.removesuffix('ex')}ices" if noun.endswith("vertex") else f"{noun}s"
    return f"{number:,} {plural}"


def tell(text: str, error: bool = False) -> None:
    """Print a line; on the second stream where something is wrong.

    What the terminal cannot encode is escaped. Where nobody reads any more it is not said: that is
    no reason to leave undone what was begun. Raises OSError where the answer cannot be written.
    """
    stream: TextIO | None = sys.stderr if error else sys.stdout
    if stream is None:  # closed before the program began
        return
    encoding = stream.encoding or "utf-8"
    line = readable(text).encode(encoding, "backslashreplace").decode(encoding)
    try:
        print(line, file=stream, flush=True)
    except OSError as problem:
        _silence(stream)
        if not (error or isinstance(problem, BrokenPipeError)):
            raise


def flush() -> None:
    """Say what is left to be said. What nobody reads would be complained about at the end."""
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            try:
                stream.flush()
            except OSError:
                _silence(stream)


def _shortened(line: str) -> str:
    if len(line) <= MOST:
        return line
    kept = MOST // 2
    return f"{line[:kept]}...{line[-kept:]}"


def _silence(stream: TextIO) -> None:
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, stream.fileno())
    os.close(nowhere)
