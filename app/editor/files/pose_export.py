"""Saving a mesh with all kept poses: morph targets of one file, or a file each beside it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

from app.editor import commands as c
from app.editor.action import Actions, check_between
from app.editor.files.mesh_saving import MeshSaving
from app.editor.files.paths import default_export_path
from app.editor.solved import settled, solved
from app.model.document import Document
from app.model.handles import Pose
from app.model.poses import REST_NAME, blended_pose
from app.telling import counted
from app.worker.errand import Snapshot
from app.workspace.tasks import Steps
from app.workspace.workspace import Workspace
from solver.mesh.pose_files import pose_paths
from solver.types import FloatArray

SOLVING = 0.7  # of the time an export takes, about


def export_poses(work: Workspace, command: c.ExportPoses) -> None:
    document, path = work.document, command.path or default_export_path(work)
    poses = poses_to_save(document, path, check_between(command.between))

    def files(file: Path) -> list[Path]:
        return [file, *map(Path, pose_paths(file, poses).values())]

    saving = MeshSaving(work, command, path, files, document.mesh, work.own)
    saving.begin(_export(saving, settled(work), poses))


def _export(
    saving: MeshSaving, shape: Steps[tuple[Snapshot, Pose]], poses: dict[str, Pose]
) -> Steps[None]:
    work, (shown, _) = saving.work, (yield from shape)
    positions = yield from solved(work, shown, 0.0)
    found: dict[str, FloatArray] = {}
    for name, pose in poses.items():
        part = SOLVING * (len(found) + 1) / (len(poses) + 1)
        found[name] = yield from solved(work, shown.posed(pose), part)
    yield from saving.steps(positions, found, SOLVING)
    work.say(f"{counted(len(poses), 'pose')}: {saving.done}")


def poses_to_save(document: Document, path: Path, between: int = 0) -> dict[str, Pose]:
    """The kept poses by what they are saved as, in their order. Raises CommandError, MeshError.

    between: so many poses more on the way from the rest shape to the first, from the first to the
    second, and so on. Morph targets are named after the pose that they lead to, files are numbered.
    """
    if not document.poses:
        raise c.CommandError("no pose is kept: there is none to save")
    if not between:
        return {kept.name: kept.pose for kept in document.poses}
    as_files = bool(pose_paths(path, ["any"]))
    named = _numbered(document, between) if as_files else _targets(document, between)
    found: dict[str, Pose] = {}
    for name, pose in named:
        if name in found:
            raise c.CommandError(f"two poses would be called {name!r}, expected distinct names")
        found[name] = pose
    return found


def _numbered(document: Document, between: int) -> Iterator[tuple[str, Pose]]:
    """From the rest shape on, so that files sorted by name play as a film."""
    steps = [(REST_NAME, "", Pose()), *_steps(document, between)]
    digits = max(len(str(len(steps) - 1)), 3)
    for number, (name, _, pose) in enumerate(steps):
        numbered = f"{number:0{digits}}"
        yield f"{numbered}-{name}" if name else numbered, pose


def _targets(document: Document, between: int) -> Iterator[tuple[str, Pose]]:
    for name, label, pose in _steps(document, between):
        yield name or label, pose


def _steps(document: Document, between: int) -> Iterator[tuple[str, str, Pose]]:
    """Of each pose on the way through all: its name if it is a kept one, how far it is, itself."""
    centres, parts = document.handle_centres(), between + 1
    stops = [(REST_NAME, Pose()), *((kept.name, kept.pose) for kept in document.poses)]
    for (_, start), (name, end) in pairwise(stops):
        for part in range(1, parts):
            pose = blended_pose(start, end, part / parts, centres)
            yield "", f"{name} {part}/{parts}", pose
        yield name, name, end


POSE_EXPORT_ACTIONS: Actions = {c.ExportPoses: export_poses}
