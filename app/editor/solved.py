"""Steps that wait for a shape of the surface."""

from __future__ import annotations

import numpy as np

from app.editor.commands import CommandError
from app.model.handles import Pose
from app.worker.errand import Errand, Snapshot
from app.worker.requests import Failure, checked
from app.worker.snapshot import snapshot
from app.workspace.late import Debt
from app.workspace.tasks import Steps
from app.workspace.workspace import Workspace
from solver.types import FloatArray


def settled(work: Workspace) -> Steps[tuple[Snapshot, Pose]]:
    """What the document asks for now, and its pose; no steps unless a drag still owes something."""
    return _settled(work, snapshot(work.document), work.document.pose, work.late.debt)


def _settled(
    work: Workspace, shape: Snapshot, pose: Pose, debt: Debt | None
) -> Steps[tuple[Snapshot, Pose]]:
    if debt is None:
        return shape, pose
    while work.late.debt is debt and not work.surface.bind_error:
        yield None
    return (shape, pose) if debt.paid is None else (shape.posed(debt.paid), debt.paid)


def until_free(work: Workspace, surface: int, fault: str) -> Steps[None]:
    """Wait until the hand is in the middle of nothing.

    surface: the `surface_number` that is asked about; CommandError with `fault` where another
    surface is there by then.
    """
    while work.interaction is not None:
        yield None
    if work.document.surface_number != surface:
        raise CommandError(fault)


def solved(work: Workspace, shape: Snapshot, fraction: float | None = None) -> Steps[FloatArray]:
    """Positions (n, 3) of a snapshot, whatever the document does meanwhile.

    Where the surface on screen comes by them nobody else is asked.
    fraction: how far the task is all the while. Raises SolverError.
    """
    errand: Errand | None = None
    try:
        while (positions := work.surface.known(shape)) is None:
            if errand is None and not _is_on_its_way(work, shape):
                errand = work.worker.errand(shape)
            if errand is not None and errand.result is not None:
                return _positions(errand)
            yield fraction
        return positions
    finally:
        if errand is not None:
            errand.wanted = False


def _is_on_its_way(work: Workspace, shape: Snapshot) -> bool:
    """Whether a snapshot is what the document asks for still, and is being worked at."""
    document = work.document
    same = document.bind_version == shape.bind.version and document.rigid == shape.rigid
    transforms = document.pose.stacked(shape.bind.keys)
    return same and work.worker.busy and np.array_equal(transforms, shape.transforms)


def _positions(errand: Errand) -> FloatArray:
    result = errand.result
    assert result is not None
    if isinstance(result, Failure):
        raise result.error
    return checked(result.positions)
