"""Saving a mesh with all kept poses: morph targets of one file, or a file each beside it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from pathlib import Path

from app.editor import commands as c
from app.editor.action import Actions, check_between
from app.editor.file_actions import default_export_path, spare_mesh, without
from app.model.document import Document
from app.model.handles import Pose
from app.model.history import Gesture
from app.model.poses import REST_NAME, blended_pose
from app.workspace.workspace import FileState, Workspace
from solver.mesh.mesh import pose_paths
from solver.mesh.progress import Progress, portion, silent
from solver.types import FloatArray

SOLVING = 0.7  # of the time an export takes, about


def export_poses(work: Workspace, command: c.ExportPoses) -> None:
    path = command.path or default_export_path(work)
    shapes = poses_to_save(work.document, path, check_between(command.between))
    beside = [Path(file) for file in pose_paths(path, shapes).values()]
    for file in (path, *beside):
        spare_mesh(work, file)
    check_free(beside, work.written)
    progress = work.progress or silent
    solved = _solved(work, shapes, portion(progress, 0.0, SOLVING))
    saving = portion(progress, SOLVING, 1.0)
    work.document.mesh.save(path, work.positions, solved, saving)
    work.written |= {file.resolve(): _state(file) for file in beside}
    beside_it = f", {len(beside)} files beside it" if beside else ""
    work.say(
        f"Exported {path} with {len(work.document.poses)} poses{beside_it}{without(work, path)}"
    )


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


def _solved(work: Workspace, poses: dict[str, Pose], tell: Progress) -> dict[str, FloatArray]:
    """Positions (n, 3) of each; the pose and the surface on screen are afterwards what they were.

    Raises SolverError.
    """
    found: dict[str, FloatArray] = {}
    gesture, parts = Gesture(work.document), len(poses) + 1

    def settle() -> FloatArray:
        work.surface.settle(work.document, lambda: tell(len(found) / parts))
        return work.positions

    try:
        for name, pose in poses.items():
            gesture.change("pose", pose)
            found[name] = settle()
    finally:
        gesture.cancel()
    settle()
    return found


POSE_EXPORT_ACTIONS: Actions = {c.ExportPoses: export_poses}
