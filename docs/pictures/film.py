"""A drag as a film, recorded by the program itself."""

from __future__ import annotations

import shutil

from app.bundled import ASSETS, DEFAULT_MESH
from app.demo import DRAG
from docs.pictures.scene import FOLDER, IMAGES, Scene, Seat, copies
from tests.gui.person import wait_until

FILM = "drag.gif"


def drag(seat: Seat) -> None:
    """The hand goes up and in, and back again."""
    person = seat.person
    person.open_section("View", "Record")
    person.choose("film")
    person.key("ctrl+a")
    person.type(FILM)
    person.key("Return")
    person.key("5")
    seat.settle()
    person.move(*seat.pixels(DRAG)[0])
    person.choose("Record")
    person.drag(seat.pixels([*DRAG, *DRAG[-2::-1]]), steps=6)
    person.choose("Record")
    made = FOLDER / FILM
    wait_until(made.exists, what=FILM)
    seat.settle()
    shutil.copy(made, IMAGES)


SCENES = (
    Scene((FILM,), copies(ASSETS / "mannequin-elbow.json", DEFAULT_MESH), drag, dialogs=False),
)
