"""What the commands do to the rest shape."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions
from app.editor.solved import settled, solved, until_free
from app.model.document import Document
from app.model.handles import Pose
from app.model.rest import RestShape, affine_fit, composed, flattens, seen_from
from app.worker.errand import Snapshot
from app.workspace.tasks import Steps
from app.workspace.workspace import Workspace
from solver.mesh.sizes import check_sizes


def make_rest(work: Workspace, command: c.MakeRest) -> None:
    document = work.document
    if document.pose.at_rest:
        raise c.CommandError("every handle is at rest: there is no other rest shape to make")
    for handle in document.handles:
        if flattens(document.pose.of(handle.key)):
            raise c.CommandError(
                f"{handle.name} is flattened: from such a shape nothing leads back"
            )
    work.tasks.begin("Making the rest shape", _make_rest(work, document, settled(work)))


def _make_rest(
    work: Workspace, document: Document, asked: Steps[tuple[Snapshot, Pose]]
) -> Steps[None]:
    shape, pose = yield from asked
    positions = yield from solved(work, shape)
    fault = "the rest shape has changed meanwhile: none was made"
    yield from until_free(work, shape.bind.mesh, fault)
    check_sizes(positions, document.mesh.faces, "the rest shape")
    rest = document.new_rest(positions)
    _set(work, "Make rest shape", rest, lambda other: seen_from(other, pose))


def restore_rest(work: Workspace, command: c.RestoreRest) -> None:
    document = work.document
    file, rest = document.mesh.vertices, document.rest_positions
    if document.rest is None:
        raise c.CommandError("the rest shape is the file's already")
    there = {}
    for key in document.bound_keys:
        vertices = document.vertices_of(key)
        if not np.array_equal(file[vertices], rest[vertices]):
            there[key] = affine_fit(file[vertices], rest[vertices])
    label = "Back to the file's rest shape"
    _set(work, label, None, lambda other: composed(other, there))


def _set(
    work: Workspace, label: str, rest: RestShape | None, moved: Callable[[Pose], Pose]
) -> None:
    """Another rest shape; `moved` gives what a pose becomes that leads where it did."""
    document = work.document
    with work.edit(label) as gesture:
        gesture.change("rest", rest)
        gesture.change("pose", moved(document.pose))
        poses = tuple(replace(kept, pose=moved(kept.pose)) for kept in document.poses)
        gesture.change("poses", poses)
        for pose in (document.pose, *(kept.pose for kept in poses)):
            work.reach.check_pose(document, pose)


REST_ACTIONS: Actions = {c.MakeRest: make_rest, c.RestoreRest: restore_rest}
