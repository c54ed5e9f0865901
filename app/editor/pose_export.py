"""Saving a mesh with all kept poses: morph targets of one file, or a file each beside it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from app.editor import commands as c
from app.editor.action import Actions, check_between
from app.editor.file_actions import default_export_path, spare_mesh
from app.editor.solved import solved
from app.model.document import Document
from app.model.handles import Pose
from app.model.poses import REST_NAME, blended_pose
from app.worker.errand import Snapshot
from app.worker.snapshot import snapshot
from app.workspace.tasks import Steps, in_background
from app.workspace.workspace import FileState, Workspace
from solver import Mesh
from solver.mesh.mesh import pose_paths
from solver.types import FloatArray

SOLVING = 0.7  # of the time an export takes, about


def export_poses(work: Workspace, command: c.ExportPoses) -> None:
    document, path = work.document, command.path or default_export_path(work)
    poses = poses_to_save(document, path, check_between(command.between))
    beside = [Path(file) for file in pose_paths(path, poses).values()]
    for file in (path, *beside):
        spare_mesh(work, file)
    check_free(beside, work.written)
    shown = snapshot(document)
    shapes = {name: shown.posed(pose) for name, pose in poses.items()}
    done = f"Exported {path} with {len(document.poses)} poses"
    steps = _solve_and_save(work, _Saving(document.mesh, path, beside, done), shown, shapes)
    work.tasks.begin(f"Exporting {path.name}", steps)


@dataclass(frozen=True)
class _Saving:
    """What is saved where. done: what is said afterwards."""

    mesh: Mesh
    path: Path
    beside: list[Path]
    done: str


def _solve_and_save(
    work: Workspace, saving: _Saving, shown: Snapshot, shapes: dict[str, Snapshot]
) -> Steps[None]:
    positions = yield from solved(work, shown, 0.0)
    found: dict[str, FloatArray] = {}
    for name, shape in shapes.items():
        part = SOLVING * (len(found) + 1) / (len(shapes) + 1)
        found[name] = yield from solved(work, shape, part)
    mesh, path, beside = saving.mesh, saving.path, saving.beside
    check_free(beside, work.written)  # once more: it may have taken its time
    yield from in_background(lambda tell: mesh.save(path, positions, found, tell), SOLVING)
    work.written |= {file.resolve(): _state(file) for file in beside}
    work.say(f"{saving.done}, {len(beside)} files beside it" if beside else saving.done)


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


def check_free(files: Iterable[Path], written: dict[Path, FileState]) -> None:
    """Raises CommandError for a file that is there, unless it is still as an export wrote it."""
    for file in files:
        if file.exists() and written.get(file.resolve()) != _state(file):
            raise c.CommandError(
                f"{file} is there already and would be replaced; expected another name, or no file"
            )


def _state(file: Path) -> FileState:
    found = file.stat()
    return found.st_mtime_ns, found.st_size


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
