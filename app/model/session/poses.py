"""Kept poses in a session file: the transforms of each by the names of the handles."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np

from app.model import schema
from app.model.document import Document
from app.model.handles import Pose
from app.model.names import free_name
from app.model.poses import KeptPose
from app.model.schema import SessionError
from solver.geometry.turns import NO_AXIS
from solver.types import FloatArray

# Radians by which a turn of a file may miss the rotation of its transform, as rounded numbers do.
SAME_TURN = 1e-2

# The panel lists them all.
MOST_POSES = 10_000

POSES = schema.list_of(
    schema.fields(
        {
            "name": schema.text,
            "transforms": schema.named(schema.transform),
            "turns": schema.named(schema.turn),
        },
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
        transforms, turns = entry["transforms"], entry.get("turns", {})
        _check_names(transforms, names, f"{where}.transforms")
        _check_names(turns, names, f"{where}.turns")
        pose = Pose({keys[handle]: T for handle, T in transforms.items()})
        for handle, turn in turns.items():
            pose = turned(pose, keys[handle], turn, f"{where}.turns.{schema.escaped(handle)}")
        found[name] = document.new_pose(pose, name)
    return tuple(found.values())


def _check_names(handles: Collection[str], names: list[str], where: str) -> None:
    for handle in handles:
        if handle not in names:
            known = f"one of {', '.join(map(repr, names))}" if names else "none"
            raise SessionError(f"{where}: unknown handle {handle!r}, expected {known}")
        if names.count(handle) > 1:
            raise SessionError(f"{where}: expected one handle of a name, got several of {handle!r}")


def turned(pose: Pose, key: int, turn: FloatArray, where: str) -> Pose:
    """The pose with a turn (3,) that a file says of a handle, which must lead to its rotation.

    Raises SessionError where it leads elsewhere.
    """
    found = pose.moved(key, pose.of(key), turn)
    if np.linalg.norm(found.turn(key) - turn) > SAME_TURN:
        raise schema.refuse(where, "a turn to where the transform leads", turn.tolist())
    return found


def written_turn(pose: Pose, key: int) -> list[float] | None:
    """None for a handle that is not turned."""
    turn = pose.turn(key)
    return turn.tolist() if np.linalg.norm(turn) > NO_AXIS else None


def written_poses(document: Document) -> list[dict[str, Any]]:
    """What `kept_poses` reads again."""
    names = handle_names(document)
    return [_written(kept, names) for kept in document.poses]


def _written(kept: KeptPose, names: dict[int, str]) -> dict[str, Any]:
    keys = [key for key in kept.pose.transforms if key in names]
    turns = {key: written_turn(kept.pose, key) for key in keys}
    entry: dict[str, Any] = {
        "name": kept.name,
        "transforms": {names[key]: kept.pose.of(key).tolist() for key in keys},
    }
    if said := {names[key]: turn for key, turn in turns.items() if turn is not None}:
        entry["turns"] = said
    return entry


def handle_names(document: Document) -> dict[int, str]:
    """The name of each handle as it is written: of several of one name all but the first get a
    number, so that poses can name each."""
    taken = {handle.name for handle in document.handles}
    names: dict[int, str] = {}
    for handle in document.handles:
        name = handle.name
        if name in names.values():
            name = free_name(name, taken, 2)
            taken.add(name)
        names[handle.key] = name
    return names
