"""Makes the pictures of the window and of the arm in README.md and the documents.

`python -m docs.make_pictures` makes all, with words only those whose name has one of them:
`python -m docs.make_pictures gizmo poses`. Needs Linux with Xvfb and xdotool: a scripted person
uses the program with a real mouse and real keys. `MAKERS` is the table.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

from app.telling import tell
from docs.pictures import close_ups, film, first_minute, guide

# What makes which files of docs/images.
MAKERS: dict[tuple[str, ...], Callable[[], None]] = {
    **{scene.pictures: scene.make for scene in (*first_minute.SCENES, *guide.SCENES, *film.SCENES)},
    close_ups.PICTURES: close_ups.make,
}


def main(words: list[str]) -> None:
    """Make what the words ask for."""
    for pictures, make in MAKERS.items():
        if not words or any(word in name for word in words for name in pictures):
            tell(", ".join(pictures))
            make()


if __name__ == "__main__":
    main(sys.argv[1:])
