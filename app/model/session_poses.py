"""Kept poses in a session file: the transforms of each by the names of the handles."""

from __future__ import annotations

import itertools
from typing import Any

from app.model import schema
from app.model.document import Document
from app.model.handles import Pose
from app.model.poses import KeptPose
from app.model.schema import SessionError

# The panel lists them all.
MOST_POSES = 10_000

POSES = schema.list_of(
    schema.fields(
        {"name": schema.text, "transforms": schema.named(schema.transform)},
        required=("name", "transforms"),
    ),
    MOST_POSES,
)


def kept_poses(document: Document, entries: list[dict[str, Any]]) -> tuple[KeptPose, ...]:
    """What POSES has passed, for a document that has its handles already. Raises SessionError."""
    names = [handle.name for handle in document.handles]
    keys = {handle.name: handle.key for handle in document.handles}
    found: dict[str, KeptPose] = {}
    for number, entry in enumerate(entries):
        where, name = f"poses[{number}]", entry["name"]
        if name in found:
            raise SessionError(f"{where}.name: expected each name once, got {name!r} twice")
        for handle in entry["transforms"]:
            if handle not in keys:
                known = f"one of {', '.join(map(repr, names))}" if names else "none"
                raise SessionError(
                    f"{where}.transforms: unknown handle {handle!r}, expected {known}"
                )
            if names.count(handle) > 1:
                raise SessionError(
                    f"{where}.transforms: expected one handle of a name, got several of {handle!r}"
                )
        pose = Pose({keys[handle]: T for handle, T in entry["transforms"].items()})
        found[name] = document.new_pose(pose, name)
    return tuple(found.values())


def written_poses(document: Document) -> list[dict[str, Any]]:
    """What `kept_poses` reads again."""
    names = handle_names(document)
    return [
        {
            "name": kept.name,
            "transforms": {
                names[key]: T.tolist() for key, T in kept.pose.transforms.items() if key in names
            },
        }
        for kept in document.poses
    ]


def handle_names(document: Document) -> dict[int, str]:
    """The name of each handle as it is written: of several of one name all but the first get a
    number, so that poses can name each."""
    taken = {handle.name for handle in document.handles}
    names: dict[int, str] = {}
    for handle in document.handles:
        name = handle.name
        if name in names.values():
            numbered = (f"{name} {number}" for number in itertools.count(2))
            name = next(free for free in numbered if free not in taken)
            taken.add(name)
        names[handle.key] = name
    return names
