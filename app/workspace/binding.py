"""Keeps the surface on screen up to date with the document: binds and poses as needed."""

from __future__ import annotations

from app.worker.requests import BindRequest, Bound, Refined, Restarted, Result
from app.workspace.workspace import Workspace
from solver.errors import SolverError


class BindError(SolverError):
    """What the document asks for could not be bound."""


def update(work: Workspace) -> None:
    """Take what the worker has finished, ask for what the document needs, pose the surface.

    During a stroke or a drag no bind is asked for. Raises SolverError if there is no pose to show.
    """
    if work.interaction is None:
        _request_bind(work)
    _take_results(work)
    work.surface.choose(work.document, work.dragging, work.worker.binding)
    # Again if a bind arrives meanwhile: what was wished for was for the one before.
    while (wish := work.surface.wish(work.document)) is not None:
        work.worker.request(wish)
        _take_results(work)
    work.surface.show(work.document)


def settle(work: Workspace) -> None:
    """Wait until the surface is what the document asks for.

    Raises BindError if it cannot be, SolverError as `update`.
    """
    update(work)
    while work.worker.busy:
        work.worker.wait()
        update(work)
    if work.bind_error:
        raise BindError(work.bind_error)
    refusal = work.surface.refusal(work.document)
    if refusal is not None:
        raise refusal


def _request_bind(work: Workspace) -> None:
    document = work.document
    if document.bind_version == work.requested_version:
        return
    work.requested_version = document.bind_version
    work.bind_error = ""
    request = BindRequest.of(document)
    if request.keys:
        work.worker.request(request)
    else:
        work.worker.drop()
        work.surface.attach(None)


def _take_results(work: Workspace) -> None:
    """All of them, even if one is an error that has to be raised."""
    refusal: SolverError | None = None
    for result in work.worker.poll():
        try:
            _take(work, result)
        except SolverError as error:
            refusal = error
    if refusal is not None:
        raise refusal


def _take(work: Workspace, result: Result) -> None:
    if isinstance(result, Bound):
        work.surface.attach(result)
        if result.pose is not None:
            work.surface.take(result.pose)
    elif isinstance(result, Refined):
        work.surface.take(result)
    elif isinstance(result, Restarted):
        work.say("The solver stopped and was started again", "error")
    elif isinstance(result.request, BindRequest):
        work.bind_error = f"Binding failed: {result.error}"
        work.say(work.bind_error, "error")
    else:
        work.surface.refuse(result.request, result.error)
        raise result.error
