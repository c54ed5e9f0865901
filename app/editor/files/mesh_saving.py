"""A mesh on its way into files: what was asked for, whatever is open by the time it is written."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from app.editor import commands as c
from app.editor.files.elsewhere import or_elsewhere
from app.editor.files.paths import recent
from app.editor.files.replacing import before_mesh, whole
from app.telling import counted
from app.workspace.own_files import OwnFiles
from app.workspace.tasks import Steps, in_background
from app.workspace.workspace import Workspace
from solver import Mesh
from solver.errors import FileError
from solver.mesh.formats.table import format_of
from solver.types import FloatArray


@dataclass(frozen=True)
class MeshSaving:
    """mesh, own: of the document that was open.  files: what is written where it goes to a path."""

    work: Workspace
    command: c.Export | c.ExportPoses
    path: Path
    files: Callable[[Path], Sequence[Path]]
    mesh: Mesh
    own: OwnFiles

    def check(self) -> None:
        """Raise Asks, CommandError or MeshError where a file must not be replaced or is no mesh."""
        if not self.path.is_dir():  # which says so itself
            format_of(self.path)
        if self._is_open:
            before_mesh(self.work, self.command, self.path, self.files)
        elif not self.command.replace and not all(map(self.own.may_replace, self.files(self.path))):
            raise FileError(
                f"{whole(self.path)}: not exported, what is there is not to be replaced"
            )

    def begin(self, export: Steps[None]) -> None:
        """Let an export begin, in place of one that waits to write the same to the same place.

        Raises what `check` raises, and what goes wrong.
        """
        self.check()
        same = type(self.command), whole(self.path), self.own
        self.work.tasks.begin(f"Exporting {self.path.name}", export, same)

    def steps(
        self,
        positions: FloatArray,
        poses: Mapping[str, FloatArray] | None = None,
        start: float = 0.0,
    ) -> Steps[None]:
        """Write the files. start: how far the task is. Raises Asks, FileError and MeshError."""
        self.check()  # once more: the shapes may have taken their time
        with self._or_elsewhere(), recent(self.work, self.path):
            yield from in_background(
                lambda tell: self.mesh.save(self.path, positions, poses, tell), start
            )
        for file in self.files(self.path):
            self.own.add(file)
        if self._is_open:
            self.work.exported = self.path

    @property
    def done(self) -> str:
        """What is said afterwards: where it is, and what its format does not keep."""
        beside, left_out = len(self.files(self.path)) - 1, self.mesh.left_out(self.path)
        parts = [f"Exported {whole(self.path)}"]
        parts += [f", {counted(beside, 'file')} beside it"] if beside else []
        parts += [f"; {left_out}"] if left_out else []
        return "".join(parts)

    @contextmanager
    def _or_elsewhere(self) -> Iterator[None]:
        """Within, the files are written; another folder is proposed for the open document only.

        The answer exports what is open: nobody asks once that is another document.
        """
        try:
            yield
        except FileError as error:
            if not self._is_open:
                raise
            with or_elsewhere(self.command, self.path):
                raise error

    @property
    def _is_open(self) -> bool:
        """Whether the document still is."""
        return self.work.own is self.own
