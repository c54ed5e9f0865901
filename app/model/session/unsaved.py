"""What a session file that the program wrote by itself says of the work that nobody saved."""

from __future__ import annotations

from app.model import schema
from app.model.document import Document
from app.telling import counted

# at: when, ISO 8601.  mesh, session: whole paths.  holds: in words.
UNSAVED = schema.fields(
    {name: schema.text for name in ("at", "mesh", "session", "holds")},
    required=("at", "mesh", "holds"),
)


def holds(document: Document) -> str:
    """What a person has made, in a few words."""
    pins = sum(handle.pin for handle in document.handles)
    counts = (
        (len(document.handles) - pins, "handle"),
        (pins, "pin"),
        (len(document.fixed), "fixed vertex"),
        (len(document.poses), "kept pose"),
    )
    found = [counted(number, noun) for number, noun in counts if number]
    if document.softness.any():
        found.append("softness")
    if document.rest is not None:
        found.append("a rest shape")
    return ", ".join(found) or "settings only"
