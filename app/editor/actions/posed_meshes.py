"""What the commands do with other shapes of the mesh: learn from them, keep their poses."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions
from app.editor.actions.poses import add_pose
from app.editor.lesson import learned, lesson, posed_vertices
from app.editor.solved import solved, until_free
from app.model.document import Document
from app.model.handles import GRAB, Pose
from app.model.names import free_name
from app.worker.apart import apart
from app.worker.snapshot import snapshot
from app.workspace.tasks import Steps, in_background
from app.workspace.workspace import Workspace
from solver.geometry.procrustes import rigid_motion
from solver.learning.examples import placed
from solver.types import FloatArray

CHANGED = "the mesh has another rest shape meanwhile: nothing was taken from files"


def learn(work: Workspace, command: c.LearnSoftness) -> None:
    if not command.paths:
        raise c.CommandError("no mesh to learn from, expected one or more")
    work.tasks.begin("Learning softness", _learn(work, work.document.frozen(), command.paths))


def _learn(work: Workspace, asked: Document, paths: Sequence[Path]) -> Steps[None]:
    poses = yield from _read(asked, paths)
    softness = yield from apart(learned, lesson(asked, poses))
    yield from until_free(work, asked.surface_number, CHANGED)
    with work.edit("Learn softness") as gesture:
        gesture.change("softness", softness, np.arange(len(softness)))
    work.map = "softness"
    work.say(f"Softness learned from {', '.join(path.name for path in paths)}")


def keep_shown_pose(work: Workspace, command: c.AddPose) -> None:
    if not any(key != GRAB for key in work.document.bound_keys):
        raise c.CommandError("there is no handle yet: paint what is to go where the mesh has it")
    name = f"Adding {command.path.name}"
    work.tasks.begin(name, _keep(work, work.document.frozen(), command.path))


def _keep(work: Workspace, asked: Document, path: Path) -> Steps[None]:
    (positions,) = yield from _read(asked, [path])
    if len(asked.fixed):
        positions = placed(positions, asked.rest_positions, asked.fixed)
    yield from until_free(work, asked.surface_number, CHANGED)
    document = work.document
    pose = shown_pose(document, positions)
    work.reach.check_pose(document, pose)
    taken = {kept.name for kept in document.poses}
    name = free_name(path.stem, taken, 2) if path.stem in taken else path.stem
    kept = document.new_pose(pose, name)
    add_pose(work, f"Add {kept.name}", kept)
    shape = yield from solved(work, snapshot(document).posed(pose))
    away = np.linalg.norm(shape - positions, axis=1) / document.diagonal
    rms = np.sqrt((away**2).mean())
    work.say(
        f"Kept {kept.name}: the surface is {rms:.2%} of its size from the mesh there, "
        f"{away.max():.2%} at most"
    )


def shown_pose(document: Document, positions: FloatArray) -> Pose:
    """Each handle where its vertices fit positions (n, 3) best, as a rigid motion."""
    pose, rest = Pose(), document.rest_positions
    for key in document.bound_keys:
        if key != GRAB:
            vertices = document.vertices_of(key)
            pose = pose.moved(key, rigid_motion(rest[vertices], positions[vertices]))
    return pose


def _read(asked: Document, paths: Sequence[Path]) -> Steps[list[FloatArray]]:
    read = yield from in_background(
        lambda tell: [posed_vertices(path, asked.mesh, asked.path) for path in paths]
    )
    return read


POSED_MESH_ACTIONS: Actions = {c.LearnSoftness: learn, c.AddPose: keep_shown_pose}
